#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "algo/types/pose.h"
#include "eval/io/table.h"
#include "eval/metrics/stem_scores.h"
#include "eval/run/stem_judgement.h"

namespace honka::eval {

/// One localization: a window, seen through so many key frames, by one variant.
struct LocalizationRow {
  std::int64_t trial = 0, window = 0, frames = 0;
  std::string variant, map, method;
  bool repaired = false;  ///< the chain that found the stems of list and map
  std::int64_t stems_in_map = 0;
  double tolerance_m2 = 0.0;

  int stems = 0, local_stars = 0, surviving_stars = 0, matches = 0, agreeing = 0;
  std::string verdict;
  bool accepted = false;
  bool success = false;  ///< accepted, and within the protocol's limits of the truth

  Pose2 T_map_local;    ///< answer; counts only where accepted
  Pose2 T_world_local;  ///< truth
  double translation_error_m = 0.0, rotation_error_rad = 0.0;  ///< of the answer, to truth
  double error_to_odometry_m = 0.0, rotation_to_odometry_rad = 0.0;

  std::array<DetectionScore, kStemRanges_m.size() - 1> detection;  ///< by range
  std::optional<double> stem_rmse_m;  ///< position error of found stems that are trees
  std::optional<double> bound_m;      ///< Cramér–Rao bound of the position
  std::optional<double> error_in_map_m, bound_in_map_m;  ///< to the map as it lies there

  double aggregate_ms = 0.0, extract_ms = 0.0, match_ms = 0.0;
  [[nodiscard]] double online_ms() const { return aggregate_ms + extract_ms + match_ms; }
};

/// "_10_20_m": ends the names of the columns of a range bin.
[[nodiscard]] std::string range_suffix(std::size_t bin);

/// The empty table of /frames; its columns are the schema.
[[nodiscard]] Table localization_table();

/// Appends a row; errors of refused answers become NaN (missing).
void append(Table& table, const LocalizationRow& row);

}  // namespace honka::eval
