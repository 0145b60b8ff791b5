#pragma once

#include <span>
#include <vector>

#include "sim/lidar/embree_scene.h"
#include "sim/lidar/ray_cone.h"

namespace honka::sim {

/// The machine's own parts that ride with the lidar: a few cones in its frame, still for one sweep.
class Occluders {
 public:
  explicit Occluders(std::span<const Cone> in_lidar);

  /// Chooses the cones that a beam of this manual azimuth can meet; for the calls that follow.
  void aim(double azimuth_rad);
  [[nodiscard]] bool in_the_way() const { return !aimed_.empty(); }
  /// First of the chosen cones along a ray in the lidar frame nearer than `far_m`.
  [[nodiscard]] Hit cast(const Ray& in_lidar, double far_m) const;

 private:
  struct Piece {
    PackedCone cone;
    Label label;
    double middle_rad = 0.0;  ///< of its sector of manual azimuths
    double half_rad = 0.0;
  };

  std::vector<Piece> pieces_;
  std::vector<const Piece*> aimed_;
};

}  // namespace honka::sim
