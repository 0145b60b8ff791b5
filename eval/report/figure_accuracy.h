#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Errors and times of the successful windows of so many key frames, one entry a window.
struct AccuracySeries {
  std::int64_t frames = 1;
  std::vector<double> rotation_error_deg;  ///< absolute
  std::vector<double> match_time_s;        ///< similarity matching
  std::vector<double> map_time_s;          ///< aggregation, segmentation, local triangulation
};

struct AccuracyFigure {
  std::vector<AccuracySeries> series;
  std::string protocol;
};

/// Li2020 Fig. 10: rotation error against time, with 2 s.d. ellipses in (error, log10 time).
[[nodiscard]] ReportFigure draw_accuracy(const std::filesystem::path& folder,
                                         const AccuracyFigure& input);

}  // namespace honka::eval
