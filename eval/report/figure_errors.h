#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Translation errors of the accepted windows of so many key frames, metres.
struct ErrorSeries {
  std::int64_t frames = 1;
  std::vector<double> to_truth_m, to_odometry_m;
};

struct ErrorsFigure {
  std::vector<ErrorSeries> series;
  std::string protocol;
};

/// Distribution of the translation error, to truth and to the odometry track, side by side.
[[nodiscard]] ReportFigure draw_errors(const std::filesystem::path& folder,
                                       const ErrorsFigure& input);

}  // namespace honka::eval
