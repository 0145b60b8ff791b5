#include "sim/forest/crown.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "sim/forest/stand.h"

namespace honka::sim {
namespace {

/// A branch from the stem's axis outwards.
struct Branch {
  double height_m = 0.0, length_m = 0.0, azimuth_rad = 0.0, rise_rad = 0.0;
};

Eigen::Vector3d axis_point(const Tree& tree, double height_m) {
  const Eigen::Vector2d centre = stem_centre_m(tree, height_m);
  return {centre.x(), centre.y(), tree.base_m.z() + height_m};
}

Eigen::Vector3d heading(const Branch& b) {
  return {std::cos(b.rise_rad) * std::cos(b.azimuth_rad),
          std::cos(b.rise_rad) * std::sin(b.azimuth_rad), std::sin(b.rise_rad)};
}

Cone branch_cone(const Tree& tree, const Branch& branch, double base_radius_m, Part part) {
  const Eigen::Vector3d a_m = axis_point(tree, branch.height_m);
  const double reach_m = branch.length_m + stem_radius_m(tree, branch.height_m);
  return {a_m, a_m + reach_m * heading(branch), base_radius_m, 0.003, {tree.id, part}};
}

/// Needles along the outer half of a branch.
Ellipsoid needles(const Cone& cone, const Branch& branch, double share, std::int32_t id) {
  const double along_m = 0.32 * branch.length_m;
  const double across_m = std::max(0.08, share * branch.length_m);
  Ellipsoid clump;
  clump.centre_m = cone.a_m + 0.72 * (cone.b_m - cone.a_m);
  clump.half_axes_m = {std::max(along_m, 0.1), across_m, 0.6 * across_m};
  clump.yaw_rad = branch.azimuth_rad;
  clump.label = {id, Part::kFoliage};
  return clump;
}

void add_live_whorls(const CrownSettings& s, const Tree& tree, RandomStream& stream, World& world) {
  const double crown_m = tree.height_m - tree.crown_base_m;
  const double radius_m = s.crown_radius_share * tree.height_m;
  const double top_m = tree.height_m - 0.6;  // above it the leader's needles hide the branches
  const auto most = static_cast<std::uint64_t>(s.branches_per_whorl_high);
  const auto least = static_cast<std::uint64_t>(s.branches_per_whorl_low);
  double height_m = tree.crown_base_m;
  while (height_m < top_m) {
    const double depth = (tree.height_m - height_m) / crown_m;  // 0 at the top, 1 at the base
    const auto count = least + stream.below(most - least + 1);
    const double first_rad = stream.uniform(-kPi, kPi);
    for (std::uint64_t i = 0; i < count; ++i) {
      Branch branch;
      branch.height_m = height_m + stream.normal(0.0, 0.03);
      branch.length_m = radius_m * (0.25 + 0.75 * std::sqrt(depth)) * stream.uniform(0.7, 1.2);
      branch.azimuth_rad = first_rad +
                           2.0 * kPi * static_cast<double>(i) / static_cast<double>(count) +
                           stream.normal(0.0, 0.2);
      branch.rise_rad = deg_to_rad(55.0 - 40.0 * depth + stream.normal(0.0, 6.0));
      world.cones.push_back(
          branch_cone(tree, branch, 0.004 + 0.011 * branch.length_m, Part::kBranch));
      if (!s.foliage) continue;
      world.ellipsoids.push_back(needles(world.cones.back(), branch, s.foliage_share, tree.id));
    }
    height_m += s.whorl_spacing_m * stream.uniform(0.8, 1.2);
  }
}

void add_leader(const Tree& tree, World& world) {
  Ellipsoid leader;
  leader.centre_m = axis_point(tree, tree.height_m - 0.3);
  leader.half_axes_m = {0.2, 0.2, 0.4};
  leader.label = {tree.id, Part::kFoliage};
  world.ellipsoids.push_back(leader);
}

void add_dead_branches(const CrownSettings& s, const Tree& tree, RandomStream& stream,
                       World& world) {
  const double from_m = s.dead_from_share * tree.crown_base_m;
  const double span_m = tree.crown_base_m - from_m;
  const int count = stream.poisson(std::max(0.0, s.dead_branches_per_m * span_m));
  for (int i = 0; i < count; ++i) {
    Branch branch;
    branch.height_m = from_m + span_m * std::sqrt(stream.uniform());  // more near the crown
    branch.length_m = stream.uniform(0.2, 1.1);
    branch.azimuth_rad = stream.uniform(-kPi, kPi);
    branch.rise_rad = deg_to_rad(stream.uniform(-15.0, 20.0));
    const double radius_m = 0.004 + 0.004 * branch.length_m;
    world.cones.push_back(branch_cone(tree, branch, radius_m, Part::kDeadBranch));
  }
}

}  // namespace

void describe(SettingsVisitor& v, CrownSettings& s) {
  v.field({"branches", "", "live and dead branches", "choice"}, s.branches);
  v.field({"foliage", "", "needles on the live branches", "choice"}, s.foliage);
  v.field({"whorl_spacing_m", "m", "mean distance from whorl to whorl",
           "Scots pine: one a year, 0.3 to 0.5 m; the upper end gives about 60 branches a tree"},
          s.whorl_spacing_m, {0.05, 5.0});
  v.field({"branches_per_whorl_low", "", "fewest branches of a whorl", "Scots pine: 4 to 6"},
          s.branches_per_whorl_low, {0, 50});
  v.field({"branches_per_whorl_high", "", "most branches of a whorl", "Scots pine: 4 to 6"},
          s.branches_per_whorl_high, {0, 50});
  v.field({"crown_radius_share", "", "longest branches over the tree's height",
           "choice: crowns 3 to 4 m wide at 17 m"},
          s.crown_radius_share, {0.01, 0.5});
  v.field({"foliage_share", "", "half the width of a clump of needles over the branch's length",
           "choice: light passes between the clumps of a pine"},
          s.foliage_share, {0.01, 1.0});
  v.field({"dead_branches_per_m", "1/m", "dead branches below the crown",
           "choice: a pine's stem is clean low down, with stubs below the crown"},
          s.dead_branches_per_m, {0.0, 50.0});
  v.field({"dead_from_share", "", "dead branches begin at this share of the crown base's height",
           "choice: the lowest third has shed them"},
          s.dead_from_share, {0.0, 1.0});
}

void add_crown(const CrownSettings& settings, const Tree& tree, std::uint64_t seed, World& world) {
  if (!settings.branches) return;
  const auto id = static_cast<std::uint64_t>(tree.id);
  RandomStream live(seed, "crown_live", {id});
  add_live_whorls(settings, tree, live, world);
  if (settings.foliage) add_leader(tree, world);
  RandomStream dead(seed, "crown_dead", {id});
  add_dead_branches(settings, tree, dead, world);
}

}  // namespace honka::sim
