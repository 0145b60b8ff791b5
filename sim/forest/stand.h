#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "sim/world/heightfield.h"
#include "sim/world/polyline.h"
#include "sim/world/world.h"

namespace honka::sim {

enum class Species : std::uint8_t { kPine, kSpruce };

/// A standing tree. World frame, metres.
struct Tree {
  std::int32_t id = -1;  ///< identity, kept by thinning; the owner of its surfaces
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();  ///< centre of the stem at the ground
  double dbh_m = 0.0;                                ///< diameter at 1.3 m
  double height_m = 0.0;                             ///< above 1.3 m
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();    ///< horizontal metres per metre of height
  double crown_base_m = 0.0;                         ///< height of the lowest live whorl
  Species species = Species::kPine;
};

/// Centre of the stem at a height above its base. World x and y, metres.
[[nodiscard]] Eigen::Vector2d stem_centre_m(const Tree& tree, double height_above_ground_m);

/// Half the stem's diameter over bark at a height above its base; 0 above the top. Metres.
[[nodiscard]] double stem_radius_m(const Tree& tree, double height_above_ground_m);

/// A shrub or juniper: a few overlapping ellipsoids on the ground.
struct Bush {
  Eigen::Vector3d base_m;
  double radius_m = 0.0, height_m = 0.0;
};

/// A young tree under the stand: a thin stem with foliage from the ground to the top.
struct Sapling {
  Eigen::Vector3d base_m;
  double height_m = 0.0;
};

struct Stump {
  Eigen::Vector3d base_m;
  double radius_m = 0.0, height_m = 0.0;
  std::int32_t tree_id = -1;  ///< of the tree that stood there, −1 for an old one
};

/// A felled stem's piece that lies on the ground.
struct Log {
  Eigen::Vector3d a_m, b_m;  ///< centres of the butt and the top end
  double radius_a_m = 0.0, radius_b_m = 0.0;
};

/// A forest as it stands: the truth that the world's surfaces and the true stem map come from.
struct Stand {
  Eigen::AlignedBox2d extent_m;  ///< the site; trees of the margin stand outside it
  Heightfield terrain;
  std::vector<Tree> trees;
  std::vector<Bush> bushes;
  std::vector<Sapling> saplings;
  std::vector<Ellipsoid> rocks;
  std::vector<Stump> stumps;
  std::vector<Log> logs;
  std::int64_t measured_trees = 0;        ///< the first trees of `trees`: those of a stem map
  std::int64_t removed_by_corridors = 0;  ///< trees of the stem map that stood in a corridor
};

}  // namespace honka::sim
