#include "sim/lidar/cone_pieces.h"

#include <algorithm>
#include <cmath>

namespace honka::sim {
namespace {

constexpr double kMostPieces = 64.0;

int piece_count(const Cone& cone, double widest_m) {
  Eigen::Array3d extent = (cone.b_m - cone.a_m).array().abs();
  std::sort(extent.data(), extent.data() + 3);
  return static_cast<int>(std::clamp(std::ceil(extent[1] / widest_m), 1.0, kMostPieces));
}

}  // namespace

ConePieces cut_into_pieces(const std::vector<Cone>& cones, double widest_m) {
  ConePieces result;
  result.cones.reserve(cones.size());
  result.labels.reserve(cones.size());
  for (const Cone& cone : cones) {
    const int pieces = piece_count(cone, widest_m);
    Cone piece = cone;
    for (int i = 1; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      piece.b_m =
          i == pieces ? cone.b_m : Eigen::Vector3d(cone.a_m + share * (cone.b_m - cone.a_m));
      piece.radius_b_m = cone.radius_a_m + share * (cone.radius_b_m - cone.radius_a_m);
      result.cones.push_back(packed(piece));
      result.labels.push_back(cone.label);
      piece.a_m = piece.b_m;
      piece.radius_a_m = piece.radius_b_m;
    }
  }
  return result;
}

Box bounds(const PackedCone& c) {
  const Eigen::Vector3d a(c.ax, c.ay, c.az), b(c.bx, c.by, c.bz);
  const Eigen::Array3d axis = (b - a).normalized().array();
  // A disc of radius r with normal n reaches r √(1 − n_i²) along axis i; the mantle goes on for
  // kJointOverlap · r along n.
  const Eigen::Array3d reach =
      (1.0 - axis.square()).max(0.0).sqrt() * 1.01 + kJointOverlap * axis.abs();
  const Eigen::Array3d low = (a.array() - c.ra * reach).min(b.array() - c.rb * reach);
  const Eigen::Array3d high = (a.array() + c.ra * reach).max(b.array() + c.rb * reach);
  // Margin for the single-precision boxes and rays of the traversal, 300 m from the origin.
  constexpr double kMargin_m = 1e-4;
  return {(low - kMargin_m).cast<float>().matrix(), (high + kMargin_m).cast<float>().matrix()};
}

}  // namespace honka::sim
