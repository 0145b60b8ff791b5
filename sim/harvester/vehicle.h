#pragma once

#include <cstdint>
#include <vector>

#include "sim/harvester/knot_trajectory.h"
#include "sim/harvester/smooth_path.h"
#include "sim/harvester/vehicle_settings.h"
#include "sim/harvester/work_plan.h"
#include "sim/world/heightfield.h"
#include "sim/world/polyline.h"

namespace honka::sim {

/// A folding-frame machine on its way. The joint follows the path; the front body, which carries
/// the lidar, looks along the path while driving and swings about the joint while standing.
class Vehicle {
 public:
  Vehicle(const Polyline& path, const Heightfield& terrain, const VehicleSettings& settings,
          std::uint64_t seed);

  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }
  [[nodiscard]] double duration_s() const { return plan_.duration_s(); }
  /// Crane, boom, head and the processed tree (parts kMachine and kLog), in the lidar frame.
  [[nodiscard]] std::vector<Cone> occluders_in_lidar(double time_s) const;
  /// Way of the joint along the path.
  [[nodiscard]] double travelled_m(double time_s) const { return plan_.travelled_m(time_s); }
  /// Angle between the two bodies, the front to the left positive.
  [[nodiscard]] double joint_angle_rad(double time_s) const;
  [[nodiscard]] const WorkPlan& plan() const { return plan_; }

 private:
  VehicleSettings settings_;
  std::uint64_t seed_;
  SmoothPath path_;
  WorkPlan plan_;
  KnotTrajectory trajectory_;
};

}  // namespace honka::sim
