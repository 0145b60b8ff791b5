#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "algo/types/pose.h"

namespace honka {

/// Paired vertices of one match and the pose that they give.
struct PoseCandidate {
  std::array<Eigen::Vector2d, 6> local_m{};
  std::array<Eigen::Vector2d, 6> map_m{};
  Pose2 T_map_local;
};

/// The pose that Eq. (4) chooses.
struct Selection {
  std::size_t chosen = 0;  ///< candidate that it is, or that it started from
  Pose2 T_map_local;
  double cost_m = 0.0;  ///< sum of |M V − V'| over all 6 m vertices
};

/// Mean of |M V − V'| over the six pairs of a candidate. Metres.
[[nodiscard]] double mean_residual_m(const PoseCandidate& candidate, const Pose2& T_map_local);

/// Largest of |M V − V'| over the six pairs of a candidate. Metres.
[[nodiscard]] double largest_residual_m(const PoseCandidate& candidate, const Pose2& T_map_local);

/// Li2020 Eq. (4) among the poses of the candidates themselves (at least one); the first of equals.
[[nodiscard]] Selection select_candidate(const std::vector<PoseCandidate>& candidates);

/// Li2020 Eq. (4) continuous in the box that the candidates' angles and translations span, by
/// reweighted least squares from the best candidate. Angles are taken relative to that candidate's,
/// as the printed box [min θ, max θ] has no meaning across ±180°.
[[nodiscard]] Selection select_in_box(const std::vector<PoseCandidate>& candidates);

}  // namespace honka
