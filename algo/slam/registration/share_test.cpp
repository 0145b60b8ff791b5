#include "algo/slam/registration/share_test.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "algo/slam/registration/trimmed_icp.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr int kFewestTiltPartners = 6;  // three heights for each of three unknowns
constexpr double kTiltLever_m = 3.0;    // spread of partners below which a tilt is noise
constexpr double kMostTilt_deg = 20.0;  // steeper than a machine drives
constexpr double kFarthest_m = 1e9;     // a double keeps a micrometre there
constexpr double kHeightGate_m = 0.5;   // five times the noise of a stem's height

/// Twice the area of the triangle a, b, c; positive when counter-clockwise.
double turn_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Andrew's monotone chain.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  const auto add_side = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= start + 2 && turn_area(hull.end()[-2], hull.back(), *it) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  if (points.size() < 3) return points;
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return hull;
}

/// Heights by which the target's partners stand above the source's, over places in the plane.
struct HeightDifferences {
  std::vector<Eigen::Vector3d> places_m;  ///< source points in the target frame
  std::vector<double> above_m;
};

/// The motion about the partners' middle that takes `difference` away: up, and a small turn.
Pose3 level(const HeightDifferences& difference) {
  const double n = static_cast<double>(difference.above_m.size());
  const double up = std::accumulate(difference.above_m.begin(), difference.above_m.end(), 0.0) / n;
  Pose3 correction = Pose3::Identity();
  correction.translation().z() = up;
  if (n < kFewestTiltPartners) return correction;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : difference.places_m) middle += p / n;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d slope_sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < difference.places_m.size(); ++i) {
    const Eigen::Vector2d at = (difference.places_m[i] - middle).head<2>();
    spread += at * at.transpose();
    slope_sum += at * (difference.above_m[i] - up);
  }
  const double half_trace = 0.5 * spread.trace();  // the lesser eigenvalue follows
  const double narrow =
      half_trace - std::sqrt(std::max(half_trace * half_trace - spread.determinant(), 0.0));
  if (narrow < n * kTiltLever_m * kTiltLever_m) return correction;
  const Eigen::Vector2d slope = spread.inverse() * slope_sum;
  const double angle = std::atan(slope.norm());
  if (angle > deg_to_rad(kMostTilt_deg) || angle == 0.0) return correction;
  const Eigen::Vector3d axis = Eigen::Vector3d(slope.y(), -slope.x(), 0.0).normalized();
  correction.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  correction.translation() = middle - correction.linear() * middle + up * Eigen::Vector3d::UnitZ();
  return correction;
}

}  // namespace

RegistrationStatus registrable_in_plane(std::span<const Eigen::Vector3d> target_m,
                                        std::span<const Eigen::Vector3d> source_m) {
  RegistrationStatus worst = RegistrationStatus::kRegistered;
  for (const auto cloud : {target_m, source_m}) {
    std::vector<Eigen::Vector3d> flat_m;
    for (const Eigen::Vector3d& p : cloud) {
      if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kFarthest_m) {
        return RegistrationStatus::kNotFinite;
      }
      flat_m.emplace_back(p.x(), p.y(), 0.0);
    }
    const RegistrationStatus status = registrable(flat_m);
    if (status != RegistrationStatus::kRegistered) worst = status;
  }
  return worst;
}

CommonView::CommonView(std::span<const Eigen::Vector3d> target_m,
                       const std::optional<ViewCone>& cone, double margin_m)
    : cone_(cone), margin_m_(margin_m) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& p : target_m) points.emplace_back(p.head<2>());
  hull_ = convex_hull(std::move(points));
  double area_m2 = 0.0;
  for (std::size_t i = 1; i + 1 < hull_.size(); ++i) {
    area_m2 += 0.5 * turn_area(hull_[0], hull_[i], hull_[i + 1]);
  }
  if (area_m2 > 0.0) per_m2_ = static_cast<double>(target_m.size()) / area_m2;
}

double CommonView::chance(double distance_m) const {
  return 1.0 - std::exp(-per_m2_ * std::numbers::pi * distance_m * distance_m);
}

double share_evidence(int partners, int points, double chance) {
  if (points <= 0) return 0.0;
  const double n = points;
  const double share = partners / n;
  const double p = std::clamp(chance, 1e-9, 1.0 - 1e-9);
  if (share <= p) return 0.0;
  const double others = share < 1.0 ? (1.0 - share) * std::log((1.0 - share) / (1.0 - p)) : 0.0;
  return n * (share * std::log(share / p) + others);
}

bool CommonView::holds(const Eigen::Vector2d& place_in_target_m) const {
  if (cone_) return cone_->holds(place_in_target_m);
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const Eigen::Vector2d& a = hull_[i];
    const Eigen::Vector2d& b = hull_[(i + 1) % hull_.size()];
    if (turn_area(a, b, place_in_target_m) < -margin_m_ * (b - a).norm()) return false;
  }
  return true;
}

double CommonView::overlap(const Pose3& T_target_source) const {
  return cone_ ? view_overlap(planar(T_target_source), *cone_) : 1.0;
}

ShareCount count_share(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                       const Pose3& T_target_source, const CommonView& view, double distance_m) {
  ShareCount count;
  for (const Eigen::Vector3d& p : source_m) {
    const Eigen::Vector2d place = (T_target_source * p).head<2>();
    const bool partner = target.nearest_planar(place).squared_m2 < distance_m * distance_m;
    const bool in_view = view.holds(place);
    count.in_view += in_view ? 1 : 0;
    count.partners_in_view += in_view && partner ? 1 : 0;
    count.partners += partner ? 1 : 0;
  }
  return count;
}

void judge_share(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                 const CommonView& view, const ShareTest& test, Registration& result) {
  const ShareCount count =
      count_share(target, source_m, result.T_target_source, view, test.distance_m);
  result.overlap = view.overlap(result.T_target_source);
  result.inliers = count.partners;
  result.share = count.share();
  const double evidence =
      share_evidence(count.partners_in_view, count.in_view, view.chance(test.distance_m));
  const bool passes = count.share() >= test.min_share && evidence >= test.min_evidence;
  result.status = passes ? RegistrationStatus::kRegistered : RegistrationStatus::kUnverified;
}

std::vector<std::pair<std::size_t, std::size_t>> partners_of(
    const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
    const Pose3& T_target_source, double distance_m) {
  std::vector<std::pair<std::size_t, std::size_t>> partners;
  for (std::size_t i = 0; i < source_m.size(); ++i) {
    const auto nearest = target.nearest_planar((T_target_source * source_m[i]).head<2>());
    if (nearest.squared_m2 >= distance_m * distance_m) continue;
    partners.emplace_back(i, static_cast<std::size_t>(nearest.index));
  }
  return partners;
}

std::size_t inlier_count(double inlier_share, std::size_t points) {
  const double exact = inlier_share * static_cast<double>(points);
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(exact - 1e-9)), 1, points);
}

double trimmed_planar_rmse(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                           const Pose3& T_target_source, double inlier_share) {
  std::vector<double> squared_m2;
  for (const Eigen::Vector3d& p : source_m) {
    squared_m2.push_back(target.nearest_planar((T_target_source * p).head<2>()).squared_m2);
  }
  const std::size_t inliers = inlier_count(inlier_share, squared_m2.size());
  const auto end = squared_m2.begin() + static_cast<std::ptrdiff_t>(inliers);
  std::nth_element(squared_m2.begin(), end - 1, squared_m2.end());
  return std::sqrt(std::accumulate(squared_m2.begin(), end, 0.0) / static_cast<double>(inliers));
}

Pose3 with_tilt(std::span<const Eigen::Vector3d> target_m, const NearestStems& target,
                std::span<const Eigen::Vector3d> source_m, const Pose3& T_target_source,
                double distance_m) {
  Pose3 result = T_target_source;
  // Once with every partner, once without those that are no stems of equal height.
  for (const double gate_m : {std::numeric_limits<double>::infinity(), kHeightGate_m}) {
    HeightDifferences difference;
    for (const auto& [s, t] : partners_of(target, source_m, result, distance_m)) {
      const Eigen::Vector3d place = result * source_m[s];
      const double above = target_m[t].z() - place.z();
      if (std::abs(above) >= gate_m) continue;
      difference.places_m.push_back(place);
      difference.above_m.push_back(above);
    }
    if (difference.above_m.empty()) break;
    result = level(difference) * result;
  }
  return result;
}

}  // namespace honka
