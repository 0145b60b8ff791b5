#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algo/localize/li2020/selection.h"

namespace honka {

/// When the search may end.
struct BoundSettings {
  double gap_m = 0.001;              ///< a vertex: 6 m of them, of the sum
  std::int64_t most_nodes = 200000;  ///< then the gap that is left is reported
};

/// The global answer of Li2020 Eq. (4), and what is proved of it.
struct BoundedSelection {
  Selection best;
  double lower_bound_m = 0.0;  ///< no pose of B × D (and of the limit) has a smaller sum
  std::int64_t nodes = 0;      ///< boxes that were looked into
  bool certified = false;      ///< best.cost_m − lower_bound_m ≤ gap_m · 6 m
};

/// Li2020 Eq. (4) minimised over all of θ ∈ B and x, y ∈ D by branch and bound, the paper's future
/// work (§4). A box about (θ, t), half sizes (δ, h): the sum f(θ, ·) is convex, so that on the box
/// it is at least f(θ, t) − |∂f/∂x| h_x − |∂f/∂y| h_y, and a turn by up to δ moves vertex V by at
/// most 2 sin(δ/2) |V|. candidates: at least one. limit: poses that it forbids are no answers.
[[nodiscard]] BoundedSelection select_by_bound(
    const std::vector<PoseCandidate>& candidates,
    const std::optional<PlaceLimit>& limit = std::nullopt, const BoundSettings& settings = {});

}  // namespace honka
