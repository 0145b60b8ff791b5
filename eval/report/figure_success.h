#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Success for windows of so many key frames, with a 95 % interval; shares in [0, 1].
struct SuccessPoint {
  std::int64_t frames = 1;
  double rate = 0.0, low = 0.0, high = 0.0;
};

struct SuccessSeries {
  std::string label;  ///< "map of a prior run"
  std::vector<SuccessPoint> points;
};

struct SuccessFigure {
  std::vector<SuccessSeries> series;
  std::vector<SuccessPoint> paper;  ///< low and high not used
  std::string protocol;
};

/// Success rate by number of key frames, Wilson intervals, the paper's figures beside.
[[nodiscard]] ReportFigure draw_success(const std::filesystem::path& folder,
                                        const SuccessFigure& input);

/// The highest speed at which the machine can drive and be localized at each window, one row each.
struct SpeedRow {
  std::string label;  ///< "C10, prior run"
  double speed_m_per_s = 0.0;
};

struct SpeedFigure {
  std::vector<SpeedRow> rows;
  std::string protocol;
};

[[nodiscard]] ReportFigure draw_speed(const std::filesystem::path& folder,
                                      const SpeedFigure& input);

}  // namespace honka::eval
