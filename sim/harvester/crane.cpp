#include "sim/harvester/crane.h"

#include <algorithm>

#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// Where the head hangs: carried close while driving, out at the stem while processing.
Eigen::Vector3d head_m(const Phase& phase, const Eigen::Vector3d& foot, std::uint64_t seed) {
  if (phase.task != Task::kProcess) return foot + Eigen::Vector3d(2.2, 0.3, 0.0);
  // A 931's crane reaches 10 m.
  RandomStream stream(seed, "vehicle_crane", {phase.stem});
  return foot + Eigen::Vector3d(stream.uniform(3.5, 7.5), stream.uniform(-1.5, 1.5), 0.0);
}

/// The stem that is fed through the head: 16 m long, across the view, its top end runs in.
Cone processed_tree(const Phase& phase, double time_s, const Eigen::Vector3d& head,
                    std::uint64_t seed) {
  RandomStream stream(seed, "vehicle_log", {phase.stem});
  const double share = phase.duration_s > 0.0
                           ? std::clamp((time_s - phase.start_s) / phase.duration_s, 0.0, 1.0)
                           : 0.0;
  const double side = stream.uniform() < 0.5 ? 1.0 : -1.0;
  const Eigen::Vector3d along =
      Eigen::Vector3d(stream.uniform(-0.4, 0.4), side, stream.uniform(-0.05, 0.05)).normalized();
  const Eigen::Vector3d grip = head + Eigen::Vector3d(0, 0, 1.3);
  constexpr double kLength_m = 16.0;
  const double fed = share * (kLength_m - 2.0);
  return {grip - (fed + 1.0) * along,
          grip + (kLength_m - 1.0 - fed) * along,
          0.12,
          0.03,
          {-1, Part::kLog}};
}

}  // namespace

std::vector<Cone> crane_in_body(const Phase& phase, double time_s, const VehicleSettings& settings,
                                std::uint64_t seed) {
  // The crane stands ahead of the cabin and to its right.
  const Eigen::Vector3d foot(settings.front_length_m + 1.0, -0.9, 0.0);
  const Eigen::Vector3d head = head_m(phase, foot, seed);
  const Eigen::Vector3d low = foot + Eigen::Vector3d(0, 0, 0.9);
  const Eigen::Vector3d pillar = foot + Eigen::Vector3d(0, 0, 2.6);
  const Eigen::Vector3d tip = head + Eigen::Vector3d(0, 0, 3.2);
  const Eigen::Vector3d knuckle = 0.5 * (pillar + tip) + Eigen::Vector3d(0, 0, 1.6);
  const Label machine = {-1, Part::kMachine};
  std::vector<Cone> cones = {
      {low, pillar, 0.22, 0.20, machine},
      {pillar, knuckle, 0.16, 0.14, machine},
      {knuckle, tip, 0.12, 0.10, machine},
      {tip, head + Eigen::Vector3d(0, 0, 2.0), 0.08, 0.08, machine},
      {head + Eigen::Vector3d(0, 0, 2.0), head + Eigen::Vector3d(0, 0, 0.8), 0.30, 0.30, machine}};
  if (phase.task == Task::kProcess) cones.push_back(processed_tree(phase, time_s, head, seed));
  return cones;
}

}  // namespace honka::sim
