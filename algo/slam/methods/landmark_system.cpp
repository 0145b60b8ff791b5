#include "algo/slam/methods/landmark_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace honka {
namespace {

/// Keeps the block of a pose that nothing holds invertible; beside any weight it is nothing.
constexpr double kHold = 1e-9;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Half of c² ln(1 + s/c²) and the weight 1/(1 + s/c²) of Cauchy's loss; s without one.
double cauchy_cost(double squares, double scale) {
  const double c2 = scale * scale;
  return scale > 0.0 ? 0.5 * c2 * std::log1p(squares / c2) : 0.5 * squares;
}
double cauchy_weight(double squares, double scale) {
  return scale > 0.0 ? 1.0 / (1.0 + squares / (scale * scale)) : 1.0;
}

double dot(const std::vector<Twist>& a, const std::vector<Twist>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

Pose3 stepped(const Pose3& pose, const Twist& step) {
  Pose3 result = pose;
  result.translation() += step.head<3>();
  result.linear() =
      Eigen::Quaterniond(so3_exp(step.tail<3>()) * pose.linear()).normalized().toRotationMatrix();
  return result;
}

LandmarkSystem::LandmarkSystem(std::span<const SparseFrame> frames, const StemMap3& map,
                               std::span<const ChainTie> chain, const LandmarkWeights& weights)
    : frames_(frames),
      map_(map),
      chain_(chain),
      weights_(weights),
      metric_(Eigen::Vector3d(weights.per_planar_m, weights.per_planar_m, weights.per_vertical_m)
                  .cwiseAbs2()) {
  first_seen_.assign(frames.size() + 1, 0);
  for (const StemObservation& o : map.observations) ++first_seen_[o.frame + 1];
  for (std::size_t l = 0; l < frames.size(); ++l) first_seen_[l + 1] += first_seen_[l];
}

double LandmarkSystem::cost(const FramePoses& poses,
                            std::span<const Eigen::Vector3d> stems_m) const {
  double sum = 0.0;
  for (const StemObservation& o : map_.observations) {
    const Eigen::Vector3d r = poses[o.frame] * frames_[o.frame].points_m[o.point] - stems_m[o.stem];
    sum += cauchy_cost(r.dot(metric_.cwiseProduct(r)), weights_.robust_scale);
  }
  for (const ChainTie& tie : chain_) {
    const Pose3 off = (poses[tie.from] * tie.T_from_next).inverse() * poses[tie.from + 1];
    sum += 0.5 * (off.translation() * weights_.per_chain_m).squaredNorm() +
           0.5 * (so3_log(off.linear()) * weights_.per_chain_rad).squaredNorm();
  }
  return sum;
}

void LandmarkSystem::linearize(const FramePoses& poses, std::span<const Eigen::Vector3d> stems_m) {
  preconditioner_.assign(poses.size(), Matrix6::Zero());
  gradient_.assign(poses.size(), Twist::Zero());
  linearize_observations(poses, stems_m);
  linearize_ties(poses);
  invert_blocks();
}

void LandmarkSystem::linearize_observations(const FramePoses& poses,
                                            std::span<const Eigen::Vector3d> stems_m) {
  seen_.clear();
  seen_.reserve(map_.observations.size());
  per_weight_.assign(stems_m.size(), 0.0);
  mean_residual_m_.assign(stems_m.size(), Eigen::Vector3d::Zero());
  for (const StemObservation& o : map_.observations) {
    const Pose3& pose = poses[o.frame];
    const Eigen::Vector3d arm_m = pose.linear() * frames_[o.frame].points_m[o.point];
    const Eigen::Vector3d r = arm_m + pose.translation() - stems_m[o.stem];
    const double weight = cauchy_weight(r.dot(metric_.cwiseProduct(r)), weights_.robust_scale);
    seen_.push_back({arm_m, weight, o.stem});
    per_weight_[o.stem] += weight;
    mean_residual_m_[o.stem] += weight * r;

    const Eigen::Vector3d pull = weight * metric_.cwiseProduct(r);
    gradient_[o.frame].head<3>() += pull;
    gradient_[o.frame].tail<3>() += arm_m.cross(pull);
    const Eigen::Matrix3d arm = cross_matrix(arm_m);
    const Eigen::Matrix3d weighted = weight * metric_.asDiagonal() * arm;
    Matrix6& block = preconditioner_[o.frame];
    block.diagonal().head<3>() += weight * metric_;
    block.topRightCorner<3, 3>() -= weighted;
    block.bottomRightCorner<3, 3>() -= arm * weighted;
  }
  for (std::size_t s = 0; s < per_weight_.size(); ++s) {
    per_weight_[s] = 1.0 / per_weight_[s];
    mean_residual_m_[s] *= per_weight_[s];
  }
}

void LandmarkSystem::linearize_ties(const FramePoses& poses) {
  const double m2 = weights_.per_chain_m * weights_.per_chain_m;
  const double rad2 = weights_.per_chain_rad * weights_.per_chain_rad;
  ties_.clear();
  for (const auto& [l, step] : chain_) {
    Tie tie;
    tie.from = l;
    tie.arm_m = poses[l].linear() * step.translation();
    tie.residual_m = poses[l + 1].translation() - poses[l].translation() - tie.arm_m;
    tie.residual_rad =
        so3_log(poses[l + 1].linear() * (poses[l].linear() * step.linear()).transpose());
    ties_.push_back(tie);
    const Eigen::Vector3d pull_m = m2 * tie.residual_m, pull_rad = rad2 * tie.residual_rad;
    gradient_[l + 1].head<3>() += pull_m;
    gradient_[l + 1].tail<3>() += pull_rad;
    gradient_[l].head<3>() -= pull_m;
    gradient_[l].tail<3>() -= tie.arm_m.cross(pull_m) + pull_rad;

    const Eigen::Matrix3d arm = cross_matrix(tie.arm_m);
    Matrix6& from = preconditioner_[l];
    Matrix6& to = preconditioner_[l + 1];
    from.topRightCorner<3, 3>() -= m2 * arm;
    from.bottomRightCorner<3, 3>() -= m2 * arm * arm;
    for (Matrix6* block : {&from, &to}) {
      block->diagonal().head<3>().array() += m2;
      block->diagonal().tail<3>().array() += rad2;
    }
  }
}

void LandmarkSystem::invert_blocks() {
  for (Matrix6& block : preconditioner_) {
    block.bottomLeftCorner<3, 3>() = block.topRightCorner<3, 3>().transpose();
    block.diagonal().array() += kHold;
    block = block.llt().solve(Matrix6::Identity()).eval();
  }
}

void LandmarkSystem::add_ties(const std::vector<Twist>& x, std::vector<Twist>& out) const {
  const double m2 = weights_.per_chain_m * weights_.per_chain_m;
  const double rad2 = weights_.per_chain_rad * weights_.per_chain_rad;
  for (const Tie& tie : ties_) {
    const std::size_t l = tie.from;
    const Eigen::Vector3d& arm_m = tie.arm_m;
    const Eigen::Vector3d turn = x[l].tail<3>();
    const Eigen::Vector3d pull_m = m2 * (x[l + 1].head<3>() - x[l].head<3>() - turn.cross(arm_m));
    const Eigen::Vector3d pull_rad = rad2 * (x[l + 1].tail<3>() - turn);
    out[l + 1].head<3>() += pull_m;
    out[l + 1].tail<3>() += pull_rad;
    out[l].head<3>() -= pull_m;
    out[l].tail<3>() -= arm_m.cross(pull_m) + pull_rad;
  }
}

std::vector<Eigen::Vector3d> LandmarkSystem::mean_moves(const std::vector<Twist>& x) const {
  std::vector<Eigen::Vector3d> means(per_weight_.size(), Eigen::Vector3d::Zero());
  for (std::size_t l = 0; l < x.size(); ++l) {
    const Eigen::Vector3d move_m = x[l].head<3>(), turn = x[l].tail<3>();
    for (const Seen& o : seen_by(l)) means[o.stem] += o.weight * (move_m + turn.cross(o.arm_m));
  }
  for (std::size_t s = 0; s < means.size(); ++s) means[s] *= per_weight_[s];
  return means;
}

void LandmarkSystem::multiply(const std::vector<Twist>& x, std::vector<Twist>& out) const {
  const std::vector<Eigen::Vector3d> followed = mean_moves(x);
  out.resize(x.size());
  for (std::size_t l = 0; l < x.size(); ++l) {
    const Eigen::Vector3d move_m = x[l].head<3>(), turn = x[l].tail<3>();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    for (const Seen& o : seen_by(l)) {
      const Eigen::Vector3d off_m = move_m + turn.cross(o.arm_m) - followed[o.stem];
      const Eigen::Vector3d one = o.weight * metric_.cwiseProduct(off_m);
      pull += one;
      torque += o.arm_m.cross(one);
    }
    out[l] << pull, torque;
  }
  add_ties(x, out);
}

/// What is left of the gradient once the stems have gone to the means of their observations.
std::vector<Twist> LandmarkSystem::reduced_gradient() const {
  std::vector<Twist> g = gradient_;
  for (std::size_t l = 0; l < g.size(); ++l) {
    for (const Seen& o : seen_by(l)) {
      const Eigen::Vector3d pull = o.weight * metric_.cwiseProduct(mean_residual_m_[o.stem]);
      g[l].head<3>() -= pull;
      g[l].tail<3>() -= o.arm_m.cross(pull);
    }
  }
  return g;
}

LandmarkSystem::Step LandmarkSystem::solve(double tolerance, int max_iterations) const {
  const std::size_t n = frames_.size();
  Step step;
  step.poses.assign(n, Twist::Zero());
  std::vector<Twist> residual = reduced_gradient(), z(n), direction, product;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = -residual[i];
    z[i] = preconditioner_[i] * residual[i];
  }
  direction = z;
  double rho = dot(residual, z);
  const double enough = rho * tolerance * tolerance;
  for (; step.iterations < max_iterations && rho > enough && rho > 0.0; ++step.iterations) {
    multiply(direction, product);
    const double curvature = dot(direction, product);
    if (!(curvature > 0.0)) break;
    const double alpha = rho / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      step.poses[i] += alpha * direction[i];
      residual[i] -= alpha * product[i];
      z[i] = preconditioner_[i] * residual[i];
    }
    const double next = dot(residual, z);
    for (std::size_t i = 0; i < n; ++i) direction[i] = z[i] + (next / rho) * direction[i];
    rho = next;
  }
  // Each stem goes to the weighted mean of its observations as they have moved.
  step.stems_m = mean_moves(step.poses);
  for (std::size_t s = 0; s < step.stems_m.size(); ++s) step.stems_m[s] += mean_residual_m_[s];
  return step;
}

}  // namespace honka
