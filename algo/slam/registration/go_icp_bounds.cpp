#include "algo/slam/registration/go_icp_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "algo/types/check.h"

namespace honka {
namespace {

constexpr int kMostPolishSteps = 40;
constexpr double kUsualLargest = 3.0;  // of the inliers' squares, over their mean
constexpr double kPolished_m = 1e-6;   // an improvement below this ends the polish

/// Sum of the `count` smallest is at least Σ min(v, t) − (n − count) t, whatever t ≥ 0: one pass
/// that settles most boxes. Four partial sums, so that additions do not wait for each other.
double least_trimmed_sum(const std::vector<double>& values, std::size_t count, double t) {
  std::array<double, 4> sums{};
  const std::size_t n = values.size();
  for (std::size_t i = 0; i + 4 <= n; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += std::min(values[i + k], t);
  }
  for (std::size_t i = n - n % 4; i < n; ++i) sums[0] += std::min(values[i], t);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]) - static_cast<double>(n - count) * t;
}

}  // namespace

TrimmedObjective::TrimmedObjective(std::span<const Eigen::Vector2d> target_m,
                                   std::span<const Eigen::Vector2d> source_m, std::size_t inliers,
                                   double margin_m)
    : target_(target_m, margin_m), inliers_(inliers) {
  HONKA_CHECK(inliers >= 1 && inliers <= source_m.size(), "inliers of the source");
  for (const Eigen::Vector2d& p : source_m) {
    x_.push_back(p.x());
    y_.push_back(p.y());
    radius_.push_back(p.norm());
    lever_m_ += p.squaredNorm() / static_cast<double>(source_m.size());
  }
  lever_m_ = std::sqrt(lever_m_);
  moved_x_.resize(x_.size());
  moved_y_.resize(x_.size());
  squared_.resize(x_.size());
  scratch_.resize(x_.size());
  order_.resize(x_.size());
}

void TrimmedObjective::move_points(const PlanarMotion& motion) {
  const double c = std::cos(motion.yaw_rad);
  const double s = std::sin(motion.yaw_rad);
  for (std::size_t i = 0; i < x_.size(); ++i) {
    moved_x_[i] = c * x_[i] - s * y_[i] + motion.shift_m.x();
    moved_y_[i] = s * x_[i] + c * y_[i] + motion.shift_m.y();
  }
  target_.squared_distances(moved_x_, moved_y_, squared_);
}

double TrimmedObjective::trimmed_rms(std::vector<double>& squared_m2) const {
  const auto end = squared_m2.begin() + static_cast<std::ptrdiff_t>(inliers_);
  if (end != squared_m2.end()) std::nth_element(squared_m2.begin(), end - 1, squared_m2.end());
  const double sum = std::accumulate(squared_m2.begin(), end, 0.0);
  return std::sqrt(sum / static_cast<double>(inliers_));
}

double TrimmedObjective::rmse(const PlanarMotion& motion) {
  move_points(motion);
  scratch_ = squared_;
  return trimmed_rms(scratch_);
}

TrimmedObjective::Bound TrimmedObjective::bound(const MotionBox& box, double interesting_m,
                                                double enough_m) {
  move_points(box.middle);
  const double inliers = static_cast<double>(inliers_);
  Bound result{0.0, std::numeric_limits<double>::infinity()};
  const double interesting = inliers * interesting_m * interesting_m;
  if (least_trimmed_sum(squared_, inliers_, kUsualLargest * interesting_m * interesting_m) <
      interesting) {
    scratch_ = squared_;
    result.middle_m = trimmed_rms(scratch_);
  }
  // Nevalainen2021 Eq. (22): no point is nearer than its distance in the middle of the box, less
  // what a turn (γ_rp) and a shift (γ_t, half the diagonal) can move it.
  const double turn = 2.0 * std::sin(std::min(0.5 * box.half_yaw_rad, 0.5 * std::numbers::pi));
  const double shift = box.half_shift_m.norm();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double left = std::max(std::sqrt(squared_[i]) - turn * radius_[i] - shift, 0.0);
    scratch_[i] = left * left;
  }
  const double enough = inliers * enough_m * enough_m;
  const double sum = least_trimmed_sum(scratch_, inliers_, kUsualLargest * enough_m * enough_m);
  result.lower_m = sum >= enough ? std::sqrt(sum / inliers) : trimmed_rms(scratch_);
  return result;
}

PlanarMotion TrimmedObjective::fit_to_nearest() {
  const auto end = order_.begin() + static_cast<std::ptrdiff_t>(inliers_);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return squared_[a] != squared_[b] ? squared_[a] < squared_[b] : a < b;
  };
  if (end != order_.end()) std::nth_element(order_.begin(), end - 1, order_.end(), nearer);
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double dot = 0.0;
  double cross = 0.0;
  for (auto it = order_.begin(); it != end; ++it) {
    const Eigen::Vector2d q = target_.points_m()[target_.nearest(moved_x_[*it], moved_y_[*it])];
    from += Eigen::Vector2d(x_[*it], y_[*it]);
    to += q;
    dot += x_[*it] * q.x() + y_[*it] * q.y();
    cross += x_[*it] * q.y() - y_[*it] * q.x();
  }
  const double n = static_cast<double>(inliers_);
  dot -= from.dot(to) / n;
  cross -= (from.x() * to.y() - from.y() * to.x()) / n;
  PlanarMotion fit;
  fit.yaw_rad = std::atan2(cross, dot);
  fit.shift_m = to / n - Eigen::Rotation2Dd(fit.yaw_rad) * (from / n);
  return fit;
}

PlanarMotion TrimmedObjective::polish(PlanarMotion motion) {
  double best = rmse(motion);
  for (int step = 0; step < kMostPolishSteps; ++step) {
    const PlanarMotion fit = fit_to_nearest();
    const double error = rmse(fit);
    ++icp_steps_;
    if (!(error < best)) break;
    motion = fit;
    const bool is_polished = best - error < kPolished_m;
    best = error;
    if (is_polished) break;
  }
  return motion;
}

}  // namespace honka
