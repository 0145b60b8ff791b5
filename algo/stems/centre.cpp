#include "algo/stems/centre.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kLeastRadius_m = 0.02, kMostRadius_m = 0.4;
constexpr double kLeastFitRadius_m = 0.03;
constexpr double kMostResidual_m = 0.03, kMostResidualShare = 0.25;
constexpr std::size_t kLeastPoints = 8;
constexpr double kTukey =
    3.5;  // times the median residual, 2.4 s.d.: a branch must not hold the fit
constexpr double kLeastArc_rad = 0.5 * kPi;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Eigen::Vector2d mean_ray(std::span<const SeenPoint> points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SeenPoint& p : points) sum += p.ray;
  return sum / static_cast<double>(points.size());
}

/// Taubin's algebraic circle, by Newton's iteration on its characteristic polynomial (Chernov
/// 2010, section 5.10). Nothing for points on a line.
std::optional<Circle> taubin(std::span<const SeenPoint> points) {
  const Eigen::Vector2d mean = mean_of(points);
  double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
  for (const SeenPoint& p : points) {
    const Eigen::Vector2d d = p.position_m - mean;
    const double z = d.squaredNorm();
    xx += d.x() * d.x(), yy += d.y() * d.y(), xy += d.x() * d.y();
    xz += d.x() * z, yz += d.y() * z, zz += z * z;
  }
  const double n = static_cast<double>(points.size());
  xx /= n, yy /= n, xy /= n, xz /= n, yz /= n, zz /= n;
  const double z_mean = xx + yy, covariance = xx * yy - xy * xy, z_variance = zz - z_mean * z_mean;
  const double a3 = 4.0 * z_mean, a2 = -3.0 * z_mean * z_mean - zz;
  const double a1 = z_variance * z_mean + 4.0 * covariance * z_mean - xz * xz - yz * yz;
  const double a0 = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - z_variance * covariance;
  double root = 0.0;
  for (int step = 0; step < 30; ++step) {
    const double slope = a1 + root * (2.0 * a2 + root * 3.0 * a3);
    const double next = root - (a0 + root * (a1 + root * (a2 + root * a3))) / slope;
    if (!std::isfinite(next) || next < 0.0 || std::abs(next - root) <= 1e-15 * std::abs(next))
      break;
    root = next;
  }
  const double det = root * root - root * z_mean + covariance;
  if (std::abs(det) < 1e-14) return std::nullopt;
  const Eigen::Vector2d centre =
      Eigen::Vector2d(xz * (yy - root) - yz * xy, yz * (xx - root) - xz * xy) / (2.0 * det);
  return Circle{mean + centre, std::sqrt(centre.squaredNorm() + z_mean)};
}

double tukey_weight(double residual_m, double limit_m) {
  const double share = residual_m / limit_m;
  if (std::abs(share) >= 1.0) return 0.0;
  return (1.0 - share * share) * (1.0 - share * share);
}

double residual_limit_m(std::span<const SeenPoint> points, const Circle& circle) {
  std::vector<double> sizes;
  sizes.reserve(points.size());
  for (const SeenPoint& p : points) {
    sizes.push_back(std::abs((p.position_m - circle.centre_m).norm() - circle.radius_m));
  }
  return std::max(kTukey * median_of(std::move(sizes)), 0.01);
}

/// Gauss–Newton on Σ w(|p − c| − r)², the Tukey limit from the median residual.
std::optional<Circle> refine(std::span<const SeenPoint> points, Circle circle) {
  constexpr int kSteps = 20, kLimitSteps = 10;
  double limit_m = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    if (step < kLimitSteps) limit_m = residual_limit_m(points, circle);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const SeenPoint& p : points) {
      const Eigen::Vector2d d = p.position_m - circle.centre_m;
      const double distance_m = d.norm();
      if (distance_m < 1e-9) continue;
      const double residual_m = distance_m - circle.radius_m;
      const Eigen::Vector3d row(-d.x() / distance_m, -d.y() / distance_m, -1.0);
      const double weight = tukey_weight(residual_m, limit_m);
      normal += weight * row * row.transpose();
      gradient += weight * residual_m * row;
    }
    const Eigen::Vector3d change = -normal.ldlt().solve(gradient);
    if (!change.allFinite()) return std::nullopt;
    circle.centre_m += change.head<2>();
    circle.radius_m += change.z();
    if (circle.radius_m <= 0.0 || circle.radius_m > 10.0) return std::nullopt;
    if (change.norm() < 1e-7) break;
  }
  return circle;
}

/// The angle around the centre that the points cover: a full turn less the widest gap.
double arc_of(std::span<const SeenPoint> points, const Circle& circle, double limit_m) {
  std::vector<double> angles;
  for (const SeenPoint& p : points) {
    const Eigen::Vector2d d = p.position_m - circle.centre_m;
    if (std::abs(d.norm() - circle.radius_m) > limit_m) continue;
    angles.push_back(std::atan2(d.y(), d.x()));
  }
  if (angles.size() < 2) return 0.0;
  std::sort(angles.begin(), angles.end());
  double gap = 2.0 * kPi - (angles.back() - angles.front());
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return 2.0 * kPi - gap;
}

bool plausible(std::span<const SeenPoint> points, const Circle& circle) {
  if (circle.radius_m < kLeastFitRadius_m || circle.radius_m > kMostRadius_m) return false;
  std::vector<double> sizes;
  double depth_m = 0.0;  // of the mean before the centre, along each point's ray
  for (const SeenPoint& p : points) {
    const Eigen::Vector2d d = circle.centre_m - p.position_m;
    sizes.push_back(std::abs(d.norm() - circle.radius_m));
    depth_m += p.ray.dot(d) / static_cast<double>(points.size());
  }
  const bool has_rays = !points.front().ray.isZero();
  if (has_rays && depth_m < 0.3 * circle.radius_m) return false;
  // 1.4826 × the median of |residual| is the s.d. of a normal one: branches do not count.
  const double residual_m = 1.4826 * median_of(sizes);
  if (residual_m > std::min(kMostResidual_m, kMostResidualShare * circle.radius_m)) return false;
  return arc_of(points, circle, 3.0 * residual_m + 0.005) >= kLeastArc_rad;
}

}  // namespace

Eigen::Vector2d mean_of(std::span<const SeenPoint> points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SeenPoint& p : points) sum += p.position_m;
  return sum / static_cast<double>(points.size());
}

Circle bias_corrected(std::span<const SeenPoint> points) {
  const Eigen::Vector2d mean = mean_of(points);
  const Eigen::Vector2d ray = mean_ray(points);
  Circle circle{mean, kLeastRadius_m};
  // With rays from several places the offsets are about the centre, not the mean: three rounds
  // bring the rest below a hundredth of r.
  std::vector<double> offsets(points.size());
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d d = points[i].position_m - circle.centre_m;
      offsets[i] = std::abs(points[i].ray.x() * d.y() - points[i].ray.y() * d.x());
    }
    circle.radius_m = std::clamp(2.0 * median_of(offsets), kLeastRadius_m, kMostRadius_m);
    circle.centre_m = mean + kMeanDepth * circle.radius_m * ray;
  }
  return circle;
}

std::optional<Circle> circle_fit(std::span<const SeenPoint> points) {
  if (points.size() < kLeastPoints) return std::nullopt;
  const std::optional<Circle> start = taubin(points);
  for (const Circle& from : {start.value_or(bias_corrected(points)), bias_corrected(points)}) {
    const std::optional<Circle> circle = refine(points, from);
    if (circle && plausible(points, *circle)) return circle;
  }
  return std::nullopt;
}

}  // namespace honka
