#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "algo/slam/sparse_frame.h"
#include "eval/report/report_model.h"

namespace honka::eval {

/// A mean that is gathered one by one; NaN of nothing.
struct RunningMean {
  double sum = 0.0;
  std::int64_t count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  void merge(const RunningMean& other) {
    sum += other.sum;
    count += other.count;
  }
  [[nodiscard]] double mean() const {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
  }
};

/// Distances to natural neighbours at a range from the scanner.
struct ViewRangeBin {
  double range_m = 0.0;  ///< middle
  RunningMean all, inner;
};

/// L0 with the rim left out and counted, and stems, of a mean frame.
struct ViewMeans {
  double inner_m = 0.0, all_m = 0.0, stems = 0.0;
};

/// Nevalainen2021 Fig. 1, left: the stems of one frame from above.
[[nodiscard]] ReportFigure draw_single_view(const std::filesystem::path& folder,
                                            const SparseFrame& frame);

/// Nevalainen2021 Fig. 1, right: the mean distance to natural neighbours at each range.
[[nodiscard]] ReportFigure draw_range_distances(const std::filesystem::path& folder,
                                                const std::vector<ViewRangeBin>& bins,
                                                const ViewMeans& means);

}  // namespace honka::eval
