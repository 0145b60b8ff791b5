#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "sim/forest/stand.h"

namespace honka::sim {

/// Ground nearer than a half-width to any of the polylines: where machines drive.
class CorridorMask {
 public:
  CorridorMask() = default;
  /// Covers queries inside `box_m`; polylines of one point are discs. Metres.
  CorridorMask(const std::vector<Polyline>& corridors, double half_width_m,
               const Eigen::AlignedBox2d& box_m);

  [[nodiscard]] bool contains(const Eigen::Vector2d& position_m) const;
  [[nodiscard]] bool empty() const { return segments_.empty(); }

 private:
  struct Segment {
    Eigen::Vector2d a_m, b_m;
  };
  void insert(const Segment& segment);

  double half_width_m_ = 0.0;
  Eigen::AlignedBox2d box_m_;
  int nx_ = 0, ny_ = 0;
  std::vector<Segment> segments_;
  std::vector<std::vector<std::uint32_t>> cells_;  ///< segments that can reach into each cell
};

/// Distance from a point to the segment a–b. Metres.
[[nodiscard]] double distance_to_segment_m(const Eigen::Vector2d& point_m,
                                           const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

}  // namespace honka::sim
