#include "algo/odometry/loam/registration.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka {
namespace {

/// Metres that one radian is worth when directions are compared: half of how far stems are seen.
constexpr double kLever_m = 10.0;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct NormalEquations {
  Matrix6 H = Matrix6::Zero();
  Twist g = Twist::Zero();
  double cost = 0.0;
};

/// Cauchy: cost c²/2 log(1 + r²/c²), weight 1/(1 + r²/c²).
double cauchy_cost(double squared, double c2) { return 0.5 * c2 * std::log1p(squared / c2); }

NormalEquations linearize(const std::vector<LoamMatch>& matches, const Pose3& T, double scale) {
  const double c2 = scale * scale;
  NormalEquations n;
  for (const LoamMatch& match : matches) {
    const Eigen::Vector2d r = match_residual(match, T);
    const MatchJacobian J = match_jacobian(match, T);
    const double weight = 1.0 / (1.0 + r.squaredNorm() / c2);
    const int rows = match.edge ? 2 : 1;
    for (int k = 0; k < rows; ++k) {
      n.H.selfadjointView<Eigen::Lower>().rankUpdate(J.row(k).transpose(), weight);
      n.g += weight * r[k] * J.row(k).transpose();
    }
    n.cost += cauchy_cost(r.squaredNorm(), c2);
  }
  n.H = Matrix6(n.H.selfadjointView<Eigen::Lower>());
  return n;
}

Twist prior_information(const LoamRegistrationSettings& s) {
  Twist sigma;
  const double angle = deg_to_rad(s.prior_deg);
  sigma << s.prior_m, s.prior_m, s.prior_m, angle, angle, angle;
  return sigma.cwiseAbs2().cwiseInverse();
}

/// The prediction as a measurement; ξ of T_predicted exp(ξ) is small, its Jacobian the identity.
void add_prior(const Twist& information, const Pose3& T_predicted, const Pose3& T,
               NormalEquations& n) {
  const Twist off = se3_log(T_predicted.inverse() * T);
  n.H.diagonal() += information;
  n.g += information.cwiseProduct(off);
  n.cost += 0.5 * off.dot(information.cwiseProduct(off));
}

/// The eigenvectors of JᵀJ, each observed or weak (Zhang2016, section III).
struct Directions {
  Matrix6 vectors = Matrix6::Identity();  ///< in metres: rotations times kLever_m
  Twist values = Twist::Zero();           ///< 1/m²
  Twist observed = Twist::Zero();         ///< 1 or 0
};

Twist lever() {
  Twist scale;
  scale << 1.0, 1.0, 1.0, kLever_m, kLever_m, kLever_m;
  return scale;
}

Directions directions_of(const Matrix6& H, double sigma_m) {
  const Twist inverse = lever().cwiseInverse();
  const Matrix6 scaled = inverse.asDiagonal() * H * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd{scaled});
  Directions d;
  d.vectors = eigen.eigenvectors();
  d.values = eigen.eigenvalues();
  const double least = 1.0 / (sigma_m * sigma_m);
  for (int k = 0; k < 6; ++k) d.observed[k] = d.values[k] > least ? 1.0 : 0.0;
  return d;
}

/// The part of a step along the observed directions: V_u of Zhang2016.
Twist remapped(const Directions& d, const Twist& step) {
  const Twist scaled = lever().asDiagonal() * step;
  const Twist kept = d.vectors * d.observed.asDiagonal() * (d.vectors.transpose() * scaled);
  return lever().cwiseInverse().asDiagonal() * kept;
}

Covariance6 covariance_of(const Directions& d) {
  Twist variances;
  for (int k = 0; k < 6; ++k) {
    variances[k] = d.observed[k] > 0.0 ? 1.0 / d.values[k] : kUnobservedVariance * kLever_m;
  }
  const Twist inverse = lever().cwiseInverse();
  const Matrix6 scaled = d.vectors * variances.asDiagonal() * d.vectors.transpose();
  return inverse.asDiagonal() * scaled * inverse.asDiagonal();
}

}  // namespace

Eigen::Vector2d match_residual(const LoamMatch& match, const Pose3& T_odom_lidar) {
  return match.normals * (T_odom_lidar * match.point_m - match.anchor_m);
}

MatchJacobian match_jacobian(const LoamMatch& match, const Pose3& T_odom_lidar) {
  // d(T exp(ξ) p) = R (ρ + φ × p), so a row n has nᵀR = m and (p × m).
  const Eigen::Matrix<double, 2, 3> m = match.normals * T_odom_lidar.linear();
  MatchJacobian J;
  J.leftCols<3>() = m;
  for (int k = 0; k < 2; ++k) {
    J.row(k).tail<3>() = match.point_m.cross(Eigen::Vector3d(m.row(k))).transpose();
  }
  return J;
}

void solve_matches(const std::vector<LoamMatch>& matches, const Pose3& T_odom_predicted,
                   const LoamRegistrationSettings& settings, LoamRegistration& result) {
  constexpr int kSteps = 4;              // the rounds of matching around it go on where it stops
  constexpr double kSmallStep_m = 1e-3;  // far below the noise of a sweep's pose
  const Twist prior = prior_information(settings);
  NormalEquations n = linearize(matches, result.T_odom_lidar, settings.robust_scale);
  const Directions directions = directions_of(n.H, settings.degenerate_sigma_m);
  result.weak_directions = 6 - static_cast<int>(directions.observed.sum());
  result.covariance = covariance_of(directions);
  result.converged = false;
  add_prior(prior, T_odom_predicted, result.T_odom_lidar, n);
  double damping = 1e-6;
  for (int i = 0; i < kSteps && !result.converged; ++i) {
    Matrix6 damped = n.H;
    damped.diagonal() += damping * n.H.diagonal();
    const Twist step = remapped(directions, -damped.ldlt().solve(n.g));
    const Pose3 T = result.T_odom_lidar * se3_exp(step);
    result.converged = (lever().asDiagonal() * step).norm() < kSmallStep_m;
    NormalEquations next = linearize(matches, T, settings.robust_scale);
    add_prior(prior, T_odom_predicted, T, next);
    if (next.cost > n.cost) {
      damping = std::max(1e-3, 10.0 * damping);
      continue;
    }
    result.T_odom_lidar = T;
    damping *= 0.1;
    n = next;
  }
}

}  // namespace honka
