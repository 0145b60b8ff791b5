#include "eval/run/localization_row.h"

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

Table localization_table() {
  return Table({
      integers("trial", "trial (stand)"),
      integers("window", "number of the window within the trial"),
      integers("frames", "key frames in the window"),
      words("variant", "way of localizing"),
      words("map", "run whose scans made the map"),
      numbers("tolerance_m2", "m2", "tolerance of a match"),
      integers("stems", "stems found in the window's cloud"),
      integers("local_stars", "interior triangle stars of the local graph"),
      integers("surviving_stars", "of these, those that stand unchanged in the map's graph"),
      integers("matches", "matching triangles"),
      integers("agreeing", "matching triangles that agree on the pose"),
      words("verdict", "accepted | ambiguous | not_in_map | too_few_stems"),
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
      integers("stems_true", "found stems with a tree within the gate"),
      numbers("stem_rmse_m", "m", "position error of the true ones"),
      numbers("bound_m", "m", "Cramér-Rao bound of the position; NaN where there is none"),
      times("aggregate_ms", "gathering the window's points"),
      times("extract_ms", "Algorithm 1"),
      times("match_ms", "triangulation and matching"),
  });
}

void append(Table& table, const LocalizationRow& row) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const auto if_accepted = [&](double value) { return row.accepted ? value : kMissing; };
  const Eigen::Vector2d& answer = row.T_map_local.translation_m;
  const Eigen::Vector2d& truth = row.T_world_local.translation_m;
  table.add_row(row.trial, row.window, row.frames, row.variant, row.map, row.tolerance_m2,
                row.stems, row.local_stars, row.surviving_stars, row.matches, row.agreeing,
                row.verdict, row.accepted, row.success, if_accepted(answer.x()),
                if_accepted(answer.y()), if_accepted(row.T_map_local.yaw_rad), truth.x(), truth.y(),
                row.T_world_local.yaw_rad, if_accepted(row.translation_error_m),
                if_accepted(row.rotation_error_rad), if_accepted(row.error_to_odometry_m),
                if_accepted(row.rotation_to_odometry_rad), row.stems_true, row.stem_rmse_m,
                row.bound_m, row.aggregate_ms, row.extract_ms, row.match_ms);
}

}  // namespace honka::eval
