#include "eval/run/localization_row.h"

#include <fmt/format.h>

#include <limits>

namespace honka::eval {
namespace {

using Doubles = std::vector<double>;
using Ints = std::vector<std::int64_t>;
using Strings = std::vector<std::string>;

Column integers(std::string name, std::string long_name) {
  return {std::move(name), "", std::move(long_name), Ints{}};
}

Column numbers(std::string name, std::string unit, std::string long_name, std::string frame = "") {
  return {std::move(name), std::move(unit), std::move(long_name), Doubles{}, true,
          std::move(frame)};
}

Column times(std::string name, std::string long_name) {
  return {std::move(name), "ms", std::move(long_name), Doubles{}, false};
}

Column words(std::string name, std::string long_name) {
  return {std::move(name), "", std::move(long_name), Strings{}};
}

}  // namespace

std::string range_suffix(std::size_t bin) {
  return fmt::format("_{:.0f}_{:.0f}_m", kStemRanges_m[bin], kStemRanges_m[bin + 1]);
}

Table localization_table() {
  Table table({
      integers("trial", "trial (stand)"),
      integers("window", "number of the window within the trial"),
      integers("frames", "key frames in the window"),
      words("variant", "way of localizing"),
      words("map", "run whose scans made the map"),
      words("method", "matcher"),
      integers("repaired", "1: height band and unbiased centres, for list and map"),
      integers("stems_in_map", "stems in the map"),
      numbers("tolerance_m2", "m2", "tolerance of a match"),
      integers("stems", "stems found in the window's cloud"),
      integers("local_stars", "interior triangle stars of the local graph"),
      integers("surviving_stars", "of these, those that stand unchanged in the map's graph"),
      integers("matches", "matching triangles"),
      integers("agreeing", "matching triangles that agree on the pose"),
      words("verdict", "accepted | ambiguous | not_in_map | too_few_stems | map_too_small"),
      integers("accepted", "1 when the answer was accepted"),
      integers("success", "1 when accepted and right"),
      numbers("x_m", "m", "answer; NaN when refused", "map"),
      numbers("y_m", "m", "answer; NaN when refused", "map"),
      numbers("yaw_rad", "rad", "answer; NaN when refused", "map"),
      numbers("true_x_m", "m", "truth", "world"),
      numbers("true_y_m", "m", "truth", "world"),
      numbers("true_yaw_rad", "rad", "truth", "world"),
      numbers("translation_error_m", "m", "distance of the answer to truth; NaN when refused"),
      numbers("rotation_error_rad", "rad", "angle of the answer to truth; NaN when refused"),
      numbers("error_to_odometry_m", "m", "distance to the odometry track; NaN when refused"),
      numbers("rotation_to_odometry_rad", "rad", "angle to the odometry track; NaN when refused"),
      numbers("stem_rmse_m", "m", "position error of found stems that are trees"),
      numbers("bound_m", "m", "Cramér-Rao bound of the position; NaN where there is none"),
      numbers("error_in_map_m", "m", "distance to the true place in the map as it lies there"),
      numbers("bound_in_map_m", "m", "Cramér-Rao bound with the map as it lies there"),
      times("aggregate_ms", "gathering the window's points"),
      times("extract_ms", "Algorithm 1"),
      times("match_ms", "triangulation and matching"),
  });
  for (std::size_t bin = 0; bin + 1 < kStemRanges_m.size(); ++bin) {
    const std::string suffix = range_suffix(bin);
    table.add_column(integers("found" + suffix, "found stems in this range"));
    table.add_column(integers("found_true" + suffix, "of these, with a tree within the gate"));
    table.add_column(integers("trees" + suffix, "trees in this range and the field of view"));
    table.add_column(integers("trees_found" + suffix, "of these, found"));
  }
  return table;
}

void append(Table& table, const LocalizationRow& row) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const auto if_accepted = [&](double value) { return row.accepted ? value : kMissing; };
  const Eigen::Vector2d& answer = row.T_map_local.translation_m;
  const Eigen::Vector2d& truth = row.T_world_local.translation_m;
  const auto& d = row.detection;
  table.add_row(row.trial, row.window, row.frames, row.variant, row.map, row.method, row.repaired,
                row.stems_in_map, row.tolerance_m2, row.stems, row.local_stars, row.surviving_stars,
                row.matches, row.agreeing, row.verdict, row.accepted, row.success,
                if_accepted(answer.x()), if_accepted(answer.y()),
                if_accepted(row.T_map_local.yaw_rad), truth.x(), truth.y(),
                row.T_world_local.yaw_rad, if_accepted(row.translation_error_m),
                if_accepted(row.rotation_error_rad), if_accepted(row.error_to_odometry_m),
                if_accepted(row.rotation_to_odometry_rad), row.stem_rmse_m.value_or(kMissing),
                row.bound_m.value_or(kMissing),
                row.accepted ? row.error_in_map_m.value_or(kMissing) : kMissing,
                row.bound_in_map_m.value_or(kMissing), row.aggregate_ms, row.extract_ms,
                row.match_ms, d[0].found, d[0].found_matched, d[0].truth, d[0].truth_matched,
                d[1].found, d[1].found_matched, d[1].truth, d[1].truth_matched, d[2].found,
                d[2].found_matched, d[2].truth, d[2].truth_matched, d[3].found, d[3].found_matched,
                d[3].truth, d[3].truth_matched);
}

}  // namespace honka::eval
