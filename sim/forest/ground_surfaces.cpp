#include "sim/forest/ground_surfaces.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

constexpr double kDisc_m = 0.01;  // half thickness of the ellipsoids that close a cut

/// A bush: five ellipsoids about its middle.
void add_bush(const Bush& bush, std::uint64_t id, std::uint64_t seed, World& world) {
  RandomStream stream(seed, "bush_form", {id});
  for (int i = 0; i < 5; ++i) {
    const double turn_rad = stream.uniform(-kPi, kPi);
    const double away_m = bush.radius_m * stream.uniform(0.2, 0.6);
    const double half_m = 0.5 * bush.height_m * stream.uniform(0.7, 1.0);
    const double wide_m = bush.radius_m * stream.uniform(0.3, 0.5);
    Ellipsoid part;
    part.centre_m = bush.base_m + Eigen::Vector3d(away_m * std::cos(turn_rad),
                                                  away_m * std::sin(turn_rad), half_m);
    part.half_axes_m = {wide_m, 0.8 * wide_m, half_m};
    part.yaw_rad = turn_rad;
    part.label = {-1, Part::kUndergrowth};
    world.ellipsoids.push_back(part);
  }
}

/// A sapling: a thin stem, and foliage that narrows to the top.
void add_sapling(const Sapling& sapling, World& world) {
  const Label label{-1, Part::kUndergrowth};
  const Eigen::Vector3d top_m = sapling.base_m + Eigen::Vector3d(0, 0, sapling.height_m);
  world.cones.push_back({sapling.base_m - Eigen::Vector3d(0, 0, 0.1), top_m,
                         0.008 * sapling.height_m + 0.004, 0.002, label});
  for (const double share : {0.3, 0.55, 0.8}) {
    const double wide_m = 0.25 * sapling.height_m * (1.05 - share);
    Ellipsoid tier;
    tier.centre_m = sapling.base_m + Eigen::Vector3d(0, 0, share * sapling.height_m);
    tier.half_axes_m = {wide_m, wide_m, 0.12 * sapling.height_m};
    tier.label = label;
    world.ellipsoids.push_back(tier);
  }
}

void add_stump(const Stump& stump, World& world) {
  const Label label{stump.tree_id, Part::kStump};
  const Eigen::Vector3d top_m = stump.base_m + Eigen::Vector3d(0, 0, stump.height_m);
  world.cones.push_back({stump.base_m - Eigen::Vector3d(0, 0, 0.3), top_m, 1.1 * stump.radius_m,
                         stump.radius_m, label});
  Ellipsoid cut;
  cut.centre_m = top_m;
  cut.half_axes_m = {stump.radius_m, stump.radius_m, kDisc_m};
  cut.label = label;
  world.ellipsoids.push_back(cut);
}

void add_log(const Log& log, World& world) {
  const Label label{-1, Part::kLog};
  world.cones.push_back({log.a_m, log.b_m, log.radius_a_m, log.radius_b_m, label});
  const Eigen::Vector3d along = log.b_m - log.a_m;
  const auto close = [&](const Eigen::Vector3d& end_m, double radius_m) {
    Ellipsoid cut;
    cut.centre_m = end_m;
    cut.half_axes_m = {kDisc_m, radius_m, radius_m};
    cut.yaw_rad = std::atan2(along.y(), along.x());
    cut.label = label;
    world.ellipsoids.push_back(cut);
  };
  close(log.a_m, log.radius_a_m);
  close(log.b_m, log.radius_b_m);
}

}  // namespace

void add_ground_surfaces(const Stand& stand, std::uint64_t seed, World& world) {
  for (std::size_t i = 0; i < stand.bushes.size(); ++i) {
    add_bush(stand.bushes[i], i, seed, world);
  }
  for (const Sapling& sapling : stand.saplings) add_sapling(sapling, world);
  world.ellipsoids.insert(world.ellipsoids.end(), stand.rocks.begin(), stand.rocks.end());
  for (const Stump& stump : stand.stumps) add_stump(stump, world);
  for (const Log& log : stand.logs) add_log(log, world);
}

}  // namespace honka::sim
