#pragma once

#include <vector>

#include "sim/lidar/ray_cone.h"

namespace honka::sim {

/// Cones as cast: long slanted ones cut into pieces, because the box around a slanted rod is
/// nearly empty and each ray through it costs a test.
struct ConePieces {
  std::vector<PackedCone> cones;
  std::vector<Label> labels;  ///< beside `cones`
};

/// Cuts every cone so that its box is at most `widest_m` across its second-longest side.
[[nodiscard]] ConePieces cut_into_pieces(const std::vector<Cone>& cones, double widest_m);

/// Box of a packed cone with its joint overlap, rounded outwards.
struct Box {
  Eigen::Vector3f low, high;
};
[[nodiscard]] Box bounds(const PackedCone& cone);

}  // namespace honka::sim
