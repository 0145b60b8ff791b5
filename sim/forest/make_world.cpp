#include <array>

#include "algo/types/random.h"
#include "sim/forest/forest.h"
#include "sim/forest/ground_surfaces.h"

namespace honka::sim {
namespace {

/// The stem as a chain of cones that meet at their joints, from below the ground to the top. The
/// joints follow the taper, close at the butt swell and wide above: the radius errs by less
/// than 1.2 % of that at a fifth of the height.
void add_stem(const Tree& tree, World& world) {
  constexpr double kSunk_m = 0.5;  // no gap under a stem that stands on a slope
  const double h = tree.height_m;
  const std::array<double, 11> joints_m = {-kSunk_m,  0.0,       0.01 * h,  0.025 * h,
                                           0.045 * h, 0.085 * h, 0.215 * h, 0.52 * h,
                                           0.71 * h,  0.895 * h, h};
  const auto point = [&](double height_m) {
    const Eigen::Vector2d centre = stem_centre_m(tree, height_m);
    return Eigen::Vector3d(centre.x(), centre.y(), tree.base_m.z() + height_m);
  };
  for (std::size_t i = 1; i < joints_m.size(); ++i) {
    world.cones.push_back({point(joints_m[i - 1]), point(joints_m[i]),
                           stem_radius_m(tree, joints_m[i - 1]), stem_radius_m(tree, joints_m[i]),
                           Label{tree.id, Part::kStem}});
  }
}

}  // namespace

World make_world(const Stand& stand, const ForestSettings& settings, std::uint64_t seed) {
  World world;
  world.meshes.push_back(stand.terrain.mesh());
  for (const Tree& tree : stand.trees) {
    add_stem(tree, world);
    add_crown(settings.crown, tree, seed, world);
  }
  add_ground_surfaces(stand, seed, world);
  return world;
}

}  // namespace honka::sim
