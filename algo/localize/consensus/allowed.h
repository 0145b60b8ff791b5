#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "algo/localize/consensus/fit.h"
#include "algo/localize/consensus/stem_grid.h"
#include "algo/localize/matcher.h"

namespace honka {

/// Where the sensor may be, in the index's coordinates: anywhere, or within a prior's circle.
class Allowed {
 public:
  Allowed(const std::optional<LocatePrior>& prior, const Eigen::Vector2d& sensor_in_frame_m,
          const Eigen::Vector2d& index_centre_m);

  [[nodiscard]] bool everywhere() const { return !prior_; }
  [[nodiscard]] bool holds(const Eigen::Vector2d& sensor_m) const {
    return !prior_ || (sensor_m - position_m_).norm() <= prior_->radius_m;
  }
  [[nodiscard]] bool operator()(const Placement& p) const { return holds(p * sensor_in_frame_m_); }
  /// Whether a stem at q in the frame may be the map stem at m: the sensor is as far from both.
  [[nodiscard]] bool may_pair(const Eigen::Vector2d& q, const Eigen::Vector2d& m,
                              double slack_m) const;

  [[nodiscard]] const Eigen::Vector2d& sensor_in_frame_m() const { return sensor_in_frame_m_; }
  [[nodiscard]] double area_m2(const StemGrid& grid) const;
  /// The active subset: map stems that a frame of this radius about its middle can reach.
  [[nodiscard]] std::vector<Eigen::Vector2d> stems(const StemGrid& grid, double radius_m) const;

 private:
  std::optional<LocatePrior> prior_;
  Eigen::Vector2d sensor_in_frame_m_, position_m_;
};

}  // namespace honka
