#include "eval/metrics/trajectory_alignment.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace honka::eval {
namespace {

constexpr std::array<const char*, 6> kNames = {"none", "origin", "yaw", "se2", "se3", "sim3"};

/// Spread across a path below this share of the spread along it is none: 0.1 mm over 100 m, well
/// above rounding (its square, which the covariance holds, is known to 1e-15).
constexpr double kNoWidth = 1e-6;
/// Covariance below this share of the spreads' product is none.
constexpr double kNoCovariance = 1e-9;

/// Means, and Σ (x_t − μ_t)(x_e − μ_e)ᵀ / n with the spread of each side.
struct Moments {
  Eigen::Vector3d truth_m, estimate_m;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double truth_spread_m = 0.0, estimate_spread_m = 0.0;  ///< √ of the mean squared distance
  double least_spread_m = 0.0;                           ///< what rounding alone may reach
};

/// Over the first `dimensions` coordinates; 2 for a plan.
Moments moments(const std::vector<PosePair>& poses, int dimensions) {
  Moments m{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const auto n = static_cast<double>(poses.size());
  double largest_m = 0.0;
  for (const PosePair& pair : poses) {
    m.truth_m += pair.truth.translation() / n;
    m.estimate_m += pair.estimate.translation() / n;
    largest_m = std::max({largest_m, pair.truth.translation().cwiseAbs().maxCoeff(),
                          pair.estimate.translation().cwiseAbs().maxCoeff()});
  }
  double truth_m2 = 0.0, estimate_m2 = 0.0;
  for (const PosePair& pair : poses) {
    Eigen::Vector3d t = pair.truth.translation() - m.truth_m;
    Eigen::Vector3d e = pair.estimate.translation() - m.estimate_m;
    if (dimensions == 2) t.z() = e.z() = 0.0;
    m.covariance += t * e.transpose() / n;
    truth_m2 += t.squaredNorm() / n;
    estimate_m2 += e.squaredNorm() / n;
  }
  m.truth_spread_m = std::sqrt(truth_m2);
  m.estimate_spread_m = std::sqrt(estimate_m2);
  m.least_spread_m = 1e-13 * largest_m;
  return m;
}

bool without_extent(const Moments& m) {
  return std::min(m.truth_spread_m, m.estimate_spread_m) <= m.least_spread_m;
}

AlignmentResult align_first(const PosePairs& pairs) {
  if (!pairs.have_rotations()) return {AlignmentStatus::kNoRotations, {}};
  const PosePair& first = pairs.poses.front();
  return {AlignmentStatus::kAligned, {1.0, first.truth * first.estimate.inverse()}};
}

/// Turn about z that maximizes Σ tᵀ R e: tan θ = Σ (e × t) / Σ (e · t).
AlignmentResult align_plan(const PosePairs& pairs, bool shift_height) {
  const Moments m = moments(pairs.poses, 2);
  const double cosine = m.covariance(0, 0) + m.covariance(1, 1);
  const double sine = m.covariance(1, 0) - m.covariance(0, 1);
  if (without_extent(m) ||
      std::hypot(cosine, sine) <= kNoCovariance * m.truth_spread_m * m.estimate_spread_m) {
    return {AlignmentStatus::kNoExtent, {}};
  }
  Pose3 rigid = pose_from_rpy(Eigen::Vector3d::Zero(), 0.0, 0.0, std::atan2(sine, cosine));
  rigid.translation() = m.truth_m - rigid.linear() * m.estimate_m;
  if (!shift_height) rigid.translation().z() = 0.0;
  return {AlignmentStatus::kAligned, {1.0, rigid}};
}

AlignmentResult align_space(const PosePairs& pairs, bool with_scale) {
  const Moments m = moments(pairs.poses, 3);
  if (without_extent(m)) return {AlignmentStatus::kNoExtent, {}};
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m.covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d d = svd.singularValues();
  const double scatter_m2 = m.truth_spread_m * m.estimate_spread_m;
  if (d[0] <= kNoCovariance * scatter_m2) return {AlignmentStatus::kNoExtent, {}};
  if (d[1] <= kNoWidth * kNoWidth * scatter_m2) return {AlignmentStatus::kCollinear, {}};
  // Umeyama1991 Eqs. (39), (40): a reflection is turned into the nearest rotation.
  Eigen::Vector3d s = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) s.z() = -1.0;
  Similarity3 T;
  T.rigid.linear() = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
  if (with_scale) T.scale = d.dot(s) / (m.estimate_spread_m * m.estimate_spread_m);  // Eq. (42)
  T.rigid.translation() = m.truth_m - T.scale * (T.rigid.linear() * m.estimate_m);   // Eq. (41)
  return {AlignmentStatus::kAligned, T};
}

}  // namespace

std::vector<std::string> alignment_names() { return {kNames.begin(), kNames.end()}; }

std::string alignment_name(Alignment alignment) {
  return kNames[static_cast<std::size_t>(alignment)];
}

std::optional<Alignment> alignment_of(std::string_view name) {
  const auto it = std::find(kNames.begin(), kNames.end(), name);
  if (it == kNames.end()) return std::nullopt;
  return static_cast<Alignment>(it - kNames.begin());
}

Pose3 Similarity3::operator*(const Pose3& pose) const {
  Pose3 result = Pose3::Identity();
  result.linear() = rigid.linear() * pose.linear();
  result.translation() = *this * Eigen::Vector3d(pose.translation());
  return result;
}

std::string alignment_problem(AlignmentStatus status) {
  switch (status) {
    case AlignmentStatus::kAligned:
      return "aligned";
    case AlignmentStatus::kNoPairs:
      return "there are no pairs of poses";
    case AlignmentStatus::kNoRotations:
      return "one trajectory knows positions alone";
    case AlignmentStatus::kNoExtent:
      return "the positions have no extent from which a heading follows";
    case AlignmentStatus::kCollinear:
      return "the positions lie on a line, about which the rotation is free";
  }
  return "";
}

AlignmentResult align(const PosePairs& pairs, Alignment alignment) {
  if (alignment == Alignment::kNone) return {};
  if (pairs.poses.empty()) return {AlignmentStatus::kNoPairs, {}};
  if (alignment == Alignment::kOrigin) return align_first(pairs);
  if (alignment == Alignment::kYaw || alignment == Alignment::kSe2) {
    return align_plan(pairs, alignment == Alignment::kYaw);
  }
  return align_space(pairs, alignment == Alignment::kSim3);
}

PosePairs moved(PosePairs pairs, const Similarity3& T_truth_estimate) {
  for (PosePair& pair : pairs.poses) pair.estimate = T_truth_estimate * pair.estimate;
  return pairs;
}

}  // namespace honka::eval
