#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/metrics/localization.h"

namespace honka::eval {

/// A plot measured in the field and seen by one terrestrial scan, and how they lie to each other.
struct StemPairPlot {
  std::string name;
  std::vector<Eigen::Vector2d> field_m, scan_m;
  Pose2 T_field_scan;  ///< by brute force
};

/// The plots that the scenario names. A relative folder counts from the present one, then from the
/// scenario's. UserError where the folder, a file, or a place of a plot is missing.
[[nodiscard]] std::vector<StemPairPlot> read_stem_pairs(const ResolvedScenario& resolved);

/// One scan asked of one field map by one matcher.
struct StemPairRow {
  std::string method, scan, map;
  bool same_plot = false;
  LocateResult result;
  PoseError deviation;  ///< from the brute-force answer; counts only of pairs
  bool success = false;
  std::int64_t stems_in_map = 0;
  double match_ms = 0.0;
};

/// Every scan in every map by every method: the methods in order, then the maps, then the scans.
[[nodiscard]] std::vector<StemPairRow> locate_stem_pairs(const Scenario& scenario,
                                                         const std::vector<StemPairPlot>& plots);

/// The rows as they stand in trials.h5.
[[nodiscard]] Table stem_pair_table(const std::vector<StemPairRow>& rows);

}  // namespace honka::eval
