#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "algo/localize/li2020/star_dimensions.h"

namespace honka {

/// Paired vertices of one match and the pose that they give.
template <int D>
struct PoseCandidateIn {
  StarVertices<D> local_m{};
  StarVertices<D> map_m{};
  StarTransform<D> T_map_local = no_motion<D>();
};
using PoseCandidate = PoseCandidateIn<2>;

/// The pose that Eq. (4) chooses.
template <int D>
struct SelectionIn {
  std::size_t chosen = 0;  ///< candidate that it is, or that it started from
  StarTransform<D> T_map_local = no_motion<D>();
  double cost_m = 0.0;  ///< sum of |M V − V'| over all 6 m vertices
};
using Selection = SelectionIn<2>;

/// A point of the local frame (the sensor) that must lie within a circle of the map's plan.
template <int D>
struct PlaceLimitIn {
  StarPoint<D> local_m = StarPoint<D>::Zero();
  Eigen::Vector2d map_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;

  [[nodiscard]] bool allows(const StarTransform<D>& T_map_local) const {
    const StarPoint<D> place_m = T_map_local * local_m;
    return (place_m.template head<2>() - map_m).norm() <= radius_m;
  }
};
using PlaceLimit = PlaceLimitIn<2>;

/// Mean of |M V − V'| over the six pairs of a candidate. Metres.
template <int D>
[[nodiscard]] double mean_residual_m(const PoseCandidateIn<D>& candidate,
                                     const StarTransform<D>& T_map_local);

/// Largest of |M V − V'| over the six pairs of a candidate. Metres.
template <int D>
[[nodiscard]] double largest_residual_m(const PoseCandidateIn<D>& candidate,
                                        const StarTransform<D>& T_map_local);

/// Li2020 Eq. (4) of a pose: sum of |M V − V'| over all 6 m vertices. Metres.
template <int D>
[[nodiscard]] double total_cost_m(const std::vector<PoseCandidateIn<D>>& candidates,
                                  const StarTransform<D>& T_map_local);

/// B and D of Li2020 Eq. (4): the ranges of angle (relative to a reference, as [min θ, max θ] has
/// no meaning across ±180°) and of translation that the candidates span.
struct CandidateBox {
  CandidateBox(const std::vector<PoseCandidate>& candidates, double reference);
  [[nodiscard]] Pose2 clamp(const Pose2& T_map_local) const;

  double reference_rad;
  double low_rad = 0.0;
  double high_rad = 0.0;
  Eigen::Vector2d low_m = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d high_m = Eigen::Vector2d::Constant(-INFINITY);
};

/// Li2020 Eq. (4) among the poses of the candidates themselves (at least one); the first of equals.
template <int D>
[[nodiscard]] SelectionIn<D> select_candidate(const std::vector<PoseCandidateIn<D>>& candidates);

/// Li2020 Eq. (4) continuous in the box that the candidates' angles and translations span, by
/// reweighted least squares from the best candidate. Angles are taken relative to that candidate's,
/// as the printed box [min θ, max θ] has no meaning across ±180°. With a limit the descent ends
/// where it would leave it.
[[nodiscard]] Selection select_in_box(const std::vector<PoseCandidate>& candidates,
                                      const std::optional<PlaceLimit>& limit = std::nullopt);

}  // namespace honka
