#include "algo/odometry/stems/registration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algo/odometry/stems/motion.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kTukeyWidth = 4.685;  // 95 % efficiency for normal errors
constexpr int kAssociations = 3, kStepsEach = 2;
constexpr double kRest_m = 1e-3, kRest_rad = 1e-4;
constexpr double kRayleighMedian = 1.1774;

double tukey_weight(double size, double width) {
  const double u = size / width;
  return u >= 1.0 ? 0.0 : (1.0 - u * u) * (1.0 - u * u);
}

Eigen::Vector2d slope_of_axis(const Eigen::Vector3d& axis) { return axis.head<2>() / axis.z(); }

}  // namespace

void place(const StemPoints& points, const std::vector<GroundPoint>& ground,
           const Twist& body_velocity, double period_s, PlacedSweep& placed) {
  placed.sightings.clear();
  placed.ground_m.clear();
  const auto T_mid_at = [&](double share) {
    return se3_exp(body_velocity * ((share - 0.5) * period_s));
  };
  for (const StemSighting& s : points.sightings) {
    const Pose3 T_mid_lidar = T_mid_at(s.share);
    placed.sightings.push_back({T_mid_lidar * s.centre_m,
                                T_mid_lidar.linear() * Eigen::Vector3d(s.slope.x(), s.slope.y(), 1),
                                s.centre_sigma_m, s.slope_sigma});
  }
  // The rings of one column are shot within a thousandth of a revolution.
  double last_share = -1.0;
  Pose3 T_mid_lidar = Pose3::Identity();
  for (const GroundPoint& g : ground) {
    if (std::abs(g.share - last_share) > 1e-3) {
      T_mid_lidar = T_mid_at(g.share);
      last_share = g.share;
    }
    placed.ground_m.push_back(T_mid_lidar * g.point_m);
  }
}

StemRegistration::StemRegistration(const StemRegistrationSettings& settings,
                                   const StemLandmarkSettings& landmarks,
                                   const StemGroundSettings& ground)
    : settings_(settings), landmarks_(landmarks), ground_(ground) {}

StemFit StemRegistration::fit(const PlacedSweep& sweep, StemLandmarkMap& stems,
                              const GroundMap& ground, const Pose3& T_odom_predicted,
                              const Covariance6& prior, const Twist& start) {
  StemFit fit;
  fit.delta = start;
  fit.T_odom_mid = moved(T_odom_predicted, start);
  double scale = 1.0;
  for (int association = 0; association < kAssociations; ++association) {
    stems.associate(sweep.sightings, fit.T_odom_mid, settings_.gate_m, pairs_);
    tie_ground(sweep, ground, fit.T_odom_mid);
    for (int step = 0; step < kStepsEach; ++step) {
      residuals(sweep, stems, fit.T_odom_mid);
      scale = median_scale();
      Normal normal;
      add_stems(scale, normal);
      add_ground(sweep, fit.T_odom_mid, normal);
      fit.information = normal.H;
      const Twist move = (normal.H + prior).ldlt().solve(Twist(normal.g - prior * fit.delta));
      if (!move.allFinite()) return fit;
      fit.delta += move;
      fit.T_odom_mid = moved(T_odom_predicted, fit.delta);
      fit.at_rest = move.head<3>().norm() < kRest_m && move.tail<3>().norm() < kRest_rad;
    }
    if (fit.at_rest) break;
  }
  residuals(sweep, stems, fit.T_odom_mid);
  keep_fitting(scale);
  fit.information /= scale * scale;
  fit.stems = pairs_.size();
  const auto seen = static_cast<double>(std::max<std::size_t>(sweep.sightings.size(), 1));
  fit.share = static_cast<double>(fit.stems) / seen;
  return fit;
}

void StemRegistration::tie_ground(const PlacedSweep& sweep, const GroundMap& ground,
                                  const Pose3& T_odom_mid) {
  ties_.clear();
  for (std::uint32_t i = 0; i < sweep.ground_m.size(); ++i) {
    const Eigen::Vector3d p = T_odom_mid * sweep.ground_m[i];
    const auto plane = ground.plane_at(p.head<2>());
    if (plane && std::abs(plane->above_m(p)) < ground_.tolerance_m) ties_.push_back({i, *plane});
  }
}

void StemRegistration::residuals(const PlacedSweep& sweep, const StemLandmarkMap& stems,
                                 const Pose3& T_odom_mid) {
  residuals_.clear();
  const double floor_slope = deg_to_rad(landmarks_.slope_sigma_deg);
  const double floor2 = landmarks_.sigma_m * landmarks_.sigma_m;
  for (const StemPair& pair : pairs_) {
    const PlacedSighting& s = sweep.sightings[pair.sighting];
    const StemLandmark& landmark = stems[pair.landmark];
    PairResidual r;
    r.lever_m = T_odom_mid.linear() * s.centre_m;
    const Eigen::Vector3d centre_m = r.lever_m + T_odom_mid.translation();
    r.place_sigma_m =
        std::sqrt(s.sigma_m * s.sigma_m + floor2 + landmark.variance_at(centre_m.z()));
    r.slope_sigma = std::sqrt(s.slope_sigma * s.slope_sigma + floor_slope * floor_slope +
                              landmark.covariance(1, 1));
    r.place = (landmark.at(centre_m.z()) - centre_m.head<2>()) / r.place_sigma_m;
    r.slope = (landmark.slope - slope_of_axis(T_odom_mid.linear() * s.axis)) / r.slope_sigma;
    residuals_.push_back(r);
  }
}

double StemRegistration::median_scale() {
  if (residuals_.empty()) return 1.0;
  sizes_.clear();
  for (const PairResidual& r : residuals_) sizes_.push_back(r.place.norm());
  const auto middle = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
  std::nth_element(sizes_.begin(), middle, sizes_.end());
  return std::max(1.0, *middle / kRayleighMedian);
}

void StemRegistration::add_stems(double scale, Normal& normal) const {
  for (const PairResidual& r : residuals_) {
    const double w = tukey_weight(r.place.norm(), kTukeyWidth * scale);
    if (w <= 0.0) continue;
    // Place: d(R q + t) = v − [R q]× ω, rows x and y.
    const Eigen::Vector3d& q = r.lever_m;
    Eigen::Matrix<double, 2, 6> J;
    J << 1, 0, 0, 0, q.z(), -q.y(), 0, 1, 0, -q.z(), 0, q.x();
    J /= r.place_sigma_m;
    normal.H += w * J.transpose() * J;
    normal.g += w * J.transpose() * r.place;
    // Axis: d(slope) = (ω_y, −ω_x) for axes near upright.
    const double ws = tukey_weight(r.slope.norm(), kTukeyWidth) / (r.slope_sigma * r.slope_sigma);
    normal.H(4, 4) += ws;
    normal.H(3, 3) += ws;
    normal.g(4) += ws * r.slope.x() * r.slope_sigma;
    normal.g(3) -= ws * r.slope.y() * r.slope_sigma;
  }
}

void StemRegistration::add_ground(const PlacedSweep& sweep, const Pose3& T_odom_mid,
                                  Normal& normal) const {
  for (const GroundTie& tie : ties_) {
    const Eigen::Vector3d q = T_odom_mid.linear() * sweep.ground_m[tie.point];
    const double above_m = tie.plane.above_m(q + T_odom_mid.translation());
    const double w = tukey_weight(std::abs(above_m) / ground_.sigma_m, kTukeyWidth) /
                     (ground_.sigma_m * ground_.sigma_m);
    if (w <= 0.0) continue;
    const Eigen::Vector3d n(-tie.plane.slope.x(), -tie.plane.slope.y(), 1.0);
    Twist J;
    J << n, q.cross(n);
    normal.H += w * J * J.transpose();
    normal.g -= w * above_m * J;
  }
}

void StemRegistration::keep_fitting(double scale) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (residuals_[i].place.norm() < kTukeyWidth * scale) pairs_[kept++] = pairs_[i];
  }
  pairs_.resize(kept);
}

}  // namespace honka
