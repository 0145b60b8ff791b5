#include "eval/run/localize/options_query.h"

#include "algo/types/angles.h"

namespace honka::eval {
namespace {

/// As the sensor would list them with its z upright and its x as before.
std::vector<Eigen::Vector3d> levelled(const sim::SlopeSighting& list) {
  const Eigen::AngleAxisd to_heading(-yaw_of(list.T_world_sensor), Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3d R_level_sensor = to_heading * list.T_world_sensor.linear();
  std::vector<Eigen::Vector3d> stems_m;
  for (const Eigen::Vector3d& stem : list.stems_in_sensor_m) {
    stems_m.emplace_back(R_level_sensor * stem);
  }
  return stems_m;
}

}  // namespace

OptionsQueries::OptionsQueries(const Scenario& scenario, const OptionsWorld& world,
                               const OptionsCase& one)
    : scenario_(scenario), world_(world), case_(one) {
  if (one.slope_deg) slope_.emplace(world.forest, deg_to_rad(*one.slope_deg));
}

OptionsQuery OptionsQueries::query(std::uint64_t number) const {
  const OptionsStudySettings& s = scenario_.options;
  const Pose2 place = sim::draw_pose(world_.forest, s.border_m, world_.seed, number);
  OptionsQuery q;
  if (!slope_) {
    q.T_map_sensor = place;
    const auto list = sim::sight(world_.forest, place, s.list, world_.seed, number);
    for (const Eigen::Vector2d& p : list.stems_in_sensor_m) q.stems_m.emplace_back(p.x(), p.y(), 0);
    return q;
  }
  auto list = sim::sight_on_slope(*slope_, place, s.list, s.height_noise_m, world_.seed, number);
  q.T_map_sensor = planar(list.T_world_sensor);
  if (case_.levelled) {
    q.stems_m = levelled(list);
  } else {
    q.stems_m = std::move(list.stems_in_sensor_m);
    q.T_map_sensor_3d = list.T_world_sensor;
  }
  return q;
}

std::vector<Eigen::Vector3d> OptionsQueries::map_m() const {
  const auto& plan_m = case_.map == "airborne" ? world_.airborne_m : world_.inventory_m;
  std::vector<Eigen::Vector3d> stems_m;
  for (const Eigen::Vector2d& p : plan_m) {
    stems_m.emplace_back(p.x(), p.y(), slope_ ? slope_->height_m(p) : 0.0);
  }
  return stems_m;
}

}  // namespace honka::eval
