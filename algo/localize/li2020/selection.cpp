#include "algo/localize/li2020/selection.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "algo/types/check.h"

namespace honka {
namespace {

/// A pose with its sine and cosine taken once.
struct PlaneMotion {
  explicit PlaneMotion(const Pose2& T)
      : cosine(std::cos(T.yaw_rad)), sine(std::sin(T.yaw_rad)), t(T.translation_m) {}

  [[nodiscard]] double residual(const Eigen::Vector2d& local, const Eigen::Vector2d& map) const {
    const double dx = cosine * local.x() - sine * local.y() + t.x() - map.x();
    const double dy = sine * local.x() + cosine * local.y() + t.y() - map.y();
    return std::sqrt(dx * dx + dy * dy);
  }

  double cosine;
  double sine;
  Eigen::Vector2d t;
};

struct SpaceMotion {
  explicit SpaceMotion(const Pose3& T) : R(T.linear()), t(T.translation()) {}

  [[nodiscard]] double residual(const Eigen::Vector3d& local, const Eigen::Vector3d& map) const {
    return (R * local + t - map).norm();
  }

  Eigen::Matrix3d R;
  Eigen::Vector3d t;
};

template <int D>
using Motion = std::conditional_t<D == 2, PlaneMotion, SpaceMotion>;

// Li2020 Eq. (4): the sum runs over all six vertices of all m matches. In the preprint's bracket
// the ones of the homogeneous vertices cancel and x, y have no effect; the journal's is meant.
template <int D>
double cost_of(std::span<const PoseCandidateIn<D>> candidates,
               const StarTransform<D>& T_map_local) {
  const Motion<D> motion(T_map_local);
  double cost = 0.0;
  for (const PoseCandidateIn<D>& c : candidates) {
    for (std::size_t j = 0; j < 6; ++j) cost += motion.residual(c.local_m[j], c.map_m[j]);
  }
  return cost;
}

/// Closed-form pose of least Σ w |R V + t − V'|², weights 1 / residual at the pose before.
Pose2 reweighted_step(const std::vector<PoseCandidate>& candidates, const Pose2& before) {
  constexpr double kLeastResidual_m = 1e-6;  // keeps the weight of an exact pair finite
  const PlaneMotion motion(before);
  double weights = 0.0;
  Eigen::Vector2d local_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d map_mean = Eigen::Vector2d::Zero();
  double dot = 0.0;
  double cross = 0.0;
  for (const PoseCandidate& c : candidates) {
    for (std::size_t j = 0; j < 6; ++j) {
      const Eigen::Vector2d& v = c.local_m[j];
      const Eigen::Vector2d& u = c.map_m[j];
      const double w = 1.0 / std::max(motion.residual(v, u), kLeastResidual_m);
      weights += w;
      local_mean += w * v;
      map_mean += w * u;
      dot += w * v.dot(u);
      cross += w * (v.x() * u.y() - v.y() * u.x());
    }
  }
  local_mean /= weights;
  map_mean /= weights;
  dot -= weights * local_mean.dot(map_mean);
  cross -= weights * (local_mean.x() * map_mean.y() - local_mean.y() * map_mean.x());
  const double yaw = std::atan2(cross, dot);
  return {map_mean - Eigen::Rotation2Dd(yaw) * local_mean, yaw};
}

}  // namespace

CandidateBox::CandidateBox(const std::vector<PoseCandidate>& candidates, double reference)
    : reference_rad(reference) {
  for (const PoseCandidate& c : candidates) {
    const double turn = wrap_to_pi(c.T_map_local.yaw_rad - reference);
    low_rad = std::min(low_rad, turn);
    high_rad = std::max(high_rad, turn);
    low_m = low_m.cwiseMin(c.T_map_local.translation_m);
    high_m = high_m.cwiseMax(c.T_map_local.translation_m);
  }
}

Pose2 CandidateBox::clamp(const Pose2& T) const {
  const double turn = std::clamp(wrap_to_pi(T.yaw_rad - reference_rad), low_rad, high_rad);
  return {T.translation_m.cwiseMax(low_m).cwiseMin(high_m), wrap_to_pi(reference_rad + turn)};
}

template <int D>
double total_cost_m(const std::vector<PoseCandidateIn<D>>& candidates,
                    const StarTransform<D>& T_map_local) {
  return cost_of<D>(candidates, T_map_local);
}

template <int D>
double mean_residual_m(const PoseCandidateIn<D>& candidate, const StarTransform<D>& T_map_local) {
  return cost_of<D>({&candidate, 1}, T_map_local) / 6.0;
}

template <int D>
double largest_residual_m(const PoseCandidateIn<D>& candidate,
                          const StarTransform<D>& T_map_local) {
  const Motion<D> motion(T_map_local);
  double largest = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    largest = std::max(largest, motion.residual(candidate.local_m[j], candidate.map_m[j]));
  }
  return largest;
}

template <int D>
SelectionIn<D> select_candidate(const std::vector<PoseCandidateIn<D>>& candidates) {
  HONKA_CHECK(!candidates.empty(), "a choice among no candidates");
  SelectionIn<D> best{0, candidates[0].T_map_local, INFINITY};
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const double cost = cost_of<D>(candidates, candidates[k].T_map_local);
    if (cost < best.cost_m) best = {k, candidates[k].T_map_local, cost};
  }
  return best;
}

template double total_cost_m(const std::vector<PoseCandidateIn<2>>&, const Pose2&);
template double total_cost_m(const std::vector<PoseCandidateIn<3>>&, const Pose3&);
template double mean_residual_m(const PoseCandidateIn<2>&, const Pose2&);
template double mean_residual_m(const PoseCandidateIn<3>&, const Pose3&);
template double largest_residual_m(const PoseCandidateIn<2>&, const Pose2&);
template double largest_residual_m(const PoseCandidateIn<3>&, const Pose3&);
template SelectionIn<2> select_candidate(const std::vector<PoseCandidateIn<2>>&);
template SelectionIn<3> select_candidate(const std::vector<PoseCandidateIn<3>>&);

Selection select_in_box(const std::vector<PoseCandidate>& candidates,
                        const std::optional<PlaceLimit>& limit) {
  constexpr int kMostSteps = 100;
  constexpr double kLeastGain_m = 1e-9;
  Selection best = select_candidate(candidates);
  const CandidateBox box(candidates, best.T_map_local.yaw_rad);
  for (int step = 0; step < kMostSteps; ++step) {
    const Pose2 pose = box.clamp(reweighted_step(candidates, best.T_map_local));
    const double cost = cost_of<2>(candidates, pose);
    if (!(cost < best.cost_m - kLeastGain_m) || (limit && !limit->allows(pose))) break;
    best.T_map_local = pose;
    best.cost_m = cost;
  }
  return best;
}

}  // namespace honka
