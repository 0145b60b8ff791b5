#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Scores of stem detection within one ring around the sensor; shares in [0, 1], NaN where unknown.
struct RangeBin {
  double low_m = 0.0, high_m = 0.0;
  double recall = 0.0, precision = 0.0;
};

struct StemRecallSeries {
  std::string label;  ///< "C10", "map"
  std::vector<RangeBin> bins;
};

struct StemRecallFigure {
  std::vector<StemRecallSeries> series;
  std::string protocol;
};

/// Recall and precision of stem detection by range.
[[nodiscard]] ReportFigure draw_stem_recall(const std::filesystem::path& folder,
                                            const StemRecallFigure& input);

}  // namespace honka::eval
