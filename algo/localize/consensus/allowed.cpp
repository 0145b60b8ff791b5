#include "algo/localize/consensus/allowed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace honka {

Allowed::Allowed(const std::optional<LocatePrior>& prior, const Eigen::Vector2d& sensor_in_frame_m,
                 const Eigen::Vector2d& index_centre_m)
    : prior_(prior), sensor_in_frame_m_(sensor_in_frame_m), position_m_(Eigen::Vector2d::Zero()) {
  if (prior_) position_m_ = prior_->position_in_map_m - index_centre_m;
}

bool Allowed::may_pair(const Eigen::Vector2d& q, const Eigen::Vector2d& m, double slack_m) const {
  if (!prior_) return true;
  const double from_sensor_m = (q - sensor_in_frame_m_).norm();
  const double from_position_m = (m - position_m_).norm();
  return std::abs(from_position_m - from_sensor_m) <= prior_->radius_m + slack_m;
}

double Allowed::area_m2(const StemGrid& grid) const {
  if (!prior_) return grid.area_m2();
  return std::min(grid.area_m2(), std::numbers::pi * prior_->radius_m * prior_->radius_m);
}

std::vector<Eigen::Vector2d> Allowed::stems(const StemGrid& grid, double radius_m) const {
  if (!prior_) return grid.stems();
  std::vector<Eigen::Vector2d> near;
  const double reach_m = prior_->radius_m + sensor_in_frame_m_.norm() + radius_m;
  for (const Eigen::Vector2d& p : grid.stems()) {
    if ((p - position_m_).norm() <= reach_m) near.push_back(p);
  }
  return near;
}

}  // namespace honka
