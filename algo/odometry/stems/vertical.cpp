#include "algo/odometry/stems/vertical.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/odometry/stems/stem_points.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kTukey = 4.685;  // 95 % efficiency for normal errors
constexpr int kVerticalIterations = 10;

/// The axis of one stem: mean over its sightings in the frame of the poses.
struct StemAxis {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< mean horizontal ray
  double weight = 0.0;                                ///< Σ 1/σ² of the slope

  void add(const StemAxis& other) {
    const double share = other.weight / (weight + other.weight);
    place_m += share * (other.place_m - place_m);
    slope += share * (other.slope - slope);
    outward += share * (other.outward - outward);
    weight += other.weight;
  }
};

double weighted_median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Axes of the stems that the sweeps show, each stem once.
std::vector<StemAxis> axes_of(std::span<const PosedSweep> sweeps, const LidarModel& model,
                              const VerticalSettings& settings) {
  StemPointFinder finder(model, settings.points);
  std::vector<StemAxis> axes;
  for (const PosedSweep& posed : sweeps) {
    const Eigen::Vector3d up = posed.T_odom_start.linear().transpose() * Eigen::Vector3d::UnitZ();
    const StemPoints& points = finder.find(*posed.sweep, up);
    for (const StemSighting& s : points.sightings) {
      const StemArc& arc = points.arcs_of(s).front();
      const Pose3 T_odom_lidar = interpolate(posed.T_odom_start, posed.T_odom_end, arc.share);
      const Eigen::Vector3d axis =
          T_odom_lidar.linear() * Eigen::Vector3d(s.slope.x(), s.slope.y(), 1.0);
      const Eigen::Vector3d ray =
          T_odom_lidar.linear() * Eigen::Vector3d(arc.ray.x(), arc.ray.y(), 0.0);
      const StemAxis seen{(T_odom_lidar * s.centre_m).head<2>(), axis.head<2>() / axis.z(),
                          ray.head<2>().normalized(), 1.0 / (s.slope_sigma * s.slope_sigma)};
      const auto same = std::find_if(axes.begin(), axes.end(), [&](const StemAxis& a) {
        return (a.place_m - seen.place_m).norm() < settings.merge_m;
      });
      if (same == axes.end()) {
        axes.push_back(seen);
      } else {
        same->add(seen);
      }
    }
  }
  return axes;
}

struct MeanAxis {
  Eigen::Vector3d unknowns = Eigen::Vector3d::Zero();  ///< slope of up (x, y), outward slope
  double slope_sigma = 0.0;
};

/// Iteratively reweighted least squares: slope = up + taper · outward + lean, with the s.d. of the
/// lean found from the residuals and the s.d. of each fit beside it.
MeanAxis mean_axis(const std::vector<StemAxis>& axes) {
  MeanAxis mean;
  std::vector<double> size(axes.size());
  std::vector<double> xs, ys;
  for (const StemAxis& a : axes) {
    xs.push_back(a.slope.x());
    ys.push_back(a.slope.y());
  }
  mean.unknowns << weighted_median(xs), weighted_median(ys), 0.0;
  const auto off = [&](const StemAxis& a) -> Eigen::Vector2d {
    return a.slope - mean.unknowns.head<2>() - mean.unknowns.z() * a.outward;
  };
  for (int iteration = 0; iteration < kVerticalIterations; ++iteration) {
    for (std::size_t i = 0; i < axes.size(); ++i) size[i] = off(axes[i]).norm();
    // The median of a Rayleigh law is 1.177 σ.
    const double lean = std::max(weighted_median(size) / 1.177, 1e-4);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero(), square = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    // A stem's near side retreats by 1 cm a metre at most: keeps the third unknown in bounds.
    information(2, 2) = 1.0 / (0.01 * 0.01);
    square(2, 2) = information(2, 2);
    for (const StemAxis& a : axes) {
      const double variance = lean * lean + 1.0 / a.weight;
      const double u = off(a).squaredNorm() / (kTukey * kTukey * variance);
      if (u >= 1.0) continue;
      const double w = (1.0 - u) * (1.0 - u) / variance;
      Eigen::Matrix<double, 2, 3> J;
      J << 1.0, 0.0, a.outward.x(), 0.0, 1.0, a.outward.y();
      information += w * J.transpose() * J;
      square += w * w * variance * J.transpose() * J;
      right += w * J.transpose() * a.slope;
    }
    mean.unknowns = information.ldlt().solve(right);
    const Eigen::Matrix3d inverse = information.inverse();
    const Eigen::Matrix3d covariance = inverse * square * inverse;
    mean.slope_sigma = std::sqrt(0.5 * covariance.topLeftCorner<2, 2>().trace());
  }
  return mean;
}

/// Near points below the horizon, in the frame of the poses.
std::vector<Eigen::Vector3d> low_points(std::span<const PosedSweep> sweeps, const LidarModel& model,
                                        const VerticalSettings& settings) {
  constexpr std::size_t kEvery = 5;
  KeyFrameSettings ranges;
  ranges.min_range_m = settings.points.min_range_m;
  ranges.max_range_m = settings.ground_range_m;
  std::vector<Eigen::Vector3d> points_m;
  std::size_t seen = 0;
  for (const PosedSweep& posed : sweeps) {
    for_each_point(posed, model, ranges, [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d off_m = p - posed.T_odom_start.translation();
      if (off_m.z() < -0.1 * off_m.head<2>().norm() && seen++ % kEvery == 0) {
        points_m.push_back(p);
      }
    });
  }
  return points_m;
}

/// Normal of a plane with as little as possible below it: the ground is under all else.
std::optional<Eigen::Vector3d> ground_normal(const std::vector<Eigen::Vector3d>& points_m) {
  if (points_m.size() < 50) return std::nullopt;
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points_m) mean_m += p;
  mean_m /= static_cast<double>(points_m.size());
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();  // z = plane · (x, y, 1) about the mean
  double limit_m = 1e3;
  for (int iteration = 0; iteration < kVerticalIterations; ++iteration) {
    Eigen::Matrix3d information = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points_m) {
      const Eigen::Vector3d q(p.x() - mean_m.x(), p.y() - mean_m.y(), 1.0);
      const double above_m = p.z() - mean_m.z() - plane.dot(q);
      if (above_m > limit_m || above_m < -2.0 * limit_m) continue;
      information += q * q.transpose();
      right += q * (p.z() - mean_m.z());
    }
    plane = information.ldlt().solve(right);
    limit_m = iteration == 0 ? 0.5 : std::max(0.6 * limit_m, 0.1);
  }
  return Eigen::Vector3d(-plane.x(), -plane.y(), 1.0).normalized();
}

}  // namespace

VerticalEstimate estimate_vertical(std::span<const PosedSweep> sweeps, const LidarModel& model,
                                   const VerticalSettings& settings) {
  VerticalEstimate vertical;
  const std::vector<StemAxis> axes = axes_of(sweeps, model, settings);
  vertical.stems = static_cast<std::int64_t>(axes.size());
  if (vertical.stems >= settings.min_stems) {
    const MeanAxis mean = mean_axis(axes);
    vertical.up = Eigen::Vector3d(mean.unknowns.x(), mean.unknowns.y(), 1.0).normalized();
    vertical.sigma_rad = mean.slope_sigma;
    vertical.source = VerticalSource::kStems;
    return vertical;
  }
  vertical.sigma_rad = 0.25 * kPi;
  if (const auto normal = ground_normal(low_points(sweeps, model, settings))) {
    vertical.up = *normal;
    vertical.sigma_rad = deg_to_rad(settings.ground_slope_deg);
    vertical.source = VerticalSource::kGround;
  }
  return vertical;
}

Pose3 levelled_start(const Eigen::Vector3d& up_in_lidar) {
  return pose_from_rpy(Eigen::Vector3d::Zero(), std::atan2(up_in_lidar.y(), up_in_lidar.z()),
                       std::asin(std::clamp(-up_in_lidar.x(), -1.0, 1.0)), 0.0);
}

}  // namespace honka
