#pragma once

#include <optional>
#include <vector>

#include "eval/run/localize/options_study.h"
#include "sim/sighting/slope.h"

namespace honka::eval {

/// A list, and where it was taken.
struct OptionsQuery {
  std::vector<Eigen::Vector3d> stems_m;  ///< in the sensor's frame; z = 0 off slopes
  Pose2 T_map_sensor;
  std::optional<Pose3> T_map_sensor_3d;  ///< on a slope, of lists that are not levelled
};

/// The map and the lists of a case: at the same places and with the same draws for every case.
class OptionsQueries {
 public:
  /// Holds on to all three.
  OptionsQueries(const Scenario& scenario, const OptionsWorld& world, const OptionsCase& one);

  [[nodiscard]] OptionsQuery query(std::uint64_t number) const;
  /// The map's stems; z is the ground's at each of them.
  [[nodiscard]] std::vector<Eigen::Vector3d> map_m() const;

 private:
  const Scenario& scenario_;
  const OptionsWorld& world_;
  const OptionsCase& case_;
  std::optional<sim::SlopedForest> slope_;
};

}  // namespace honka::eval
