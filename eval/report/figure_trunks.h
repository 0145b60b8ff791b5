#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// A count per window for windows of so many key frames.
struct WindowCounts {
  std::int64_t frames = 1;
  std::vector<double> counts;        ///< in the order of the windows along the path
  std::optional<double> paper_mean;  ///< Li2020 Table 1
};

struct WindowCountsFigure {
  std::vector<WindowCounts> series;  ///< C1, C3, C5, C10: one panel each
  std::string protocol;
};

/// Li2020 Fig. 8: trunks found in each window; our mean solid, the paper's dashed.
[[nodiscard]] ReportFigure draw_trunks(const std::filesystem::path& folder,
                                       const WindowCountsFigure& input);

/// Li2020 Fig. 9: matching triangles in each window.
[[nodiscard]] ReportFigure draw_matches(const std::filesystem::path& folder,
                                        const WindowCountsFigure& input);

}  // namespace honka::eval
