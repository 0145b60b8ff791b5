#include "sim/harvester/vehicle.h"

#include <cmath>

#include "algo/types/random.h"
#include "sim/harvester/crane.h"
#include "sim/harvester/truth_knots.h"

namespace honka::sim {

Vehicle::Vehicle(const Polyline& path, const Heightfield& terrain, const VehicleSettings& settings,
                 std::uint64_t seed)
    : settings_(settings),
      seed_(seed),
      path_(path),
      plan_(path_.length_m(), settings, seed),
      trajectory_(kTruthKnot_s, truth_knots(path_, plan_, terrain, settings, seed)) {}

std::vector<Cone> Vehicle::occluders_in_lidar(double time_s) const {
  if (!settings_.occluders) return {};
  Pose3 T_body_lidar = pose_from_rpy({settings_.joint_to_lidar_m, 0.0, settings_.sensor_height_m},
                                     deg_to_rad(settings_.mount_roll_deg),
                                     deg_to_rad(settings_.mount_pitch_deg), 0.0);
  const Pose3 T_lidar_body = T_body_lidar.inverse();
  std::vector<Cone> cones = crane_in_body(plan_.at(time_s), time_s, settings_, seed_);
  for (Cone& cone : cones) {
    cone.a_m = T_lidar_body * cone.a_m;
    cone.b_m = T_lidar_body * cone.b_m;
  }
  return cones;
}

double Vehicle::joint_angle_rad(double time_s) const {
  const double along = plan_.travelled_m(time_s);
  const Eigen::Vector2d rear = path_.at(along) - path_.at(along - settings_.rear_length_m);
  const double front = driving_direction_rad(path_, along, settings_.front_length_m);
  return wrap_to_pi(front + plan_.swing_rad(time_s) - std::atan2(rear.y(), rear.x()));
}

}  // namespace honka::sim
