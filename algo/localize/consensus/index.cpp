#include "algo/localize/consensus/index.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <utility>

#include "algo/localize/consensus/frame.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Whole metres near the middle.
Eigen::Vector2d whole_middle(std::span<const Eigen::Vector2d> stems) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : stems) sum += p / static_cast<double>(stems.size());
  return sum.array().round();
}

Points centred(std::span<const Eigen::Vector2d> stems, const Eigen::Vector2d& centre) {
  Points points(stems.begin(), stems.end());
  for (Eigen::Vector2d& p : points) p -= centre;
  return points;
}

}  // namespace

std::uint64_t map_hash(std::span<const Eigen::Vector2d> stems_in_map_m) {
  std::uint64_t hash = mix64(stems_in_map_m.size());
  for (const Eigen::Vector2d& p : stems_in_map_m) {
    for (const double value : {p.x(), p.y()}) {
      hash = mix64(hash ^ std::bit_cast<std::uint64_t>(value + 0.0));
    }
  }
  return hash;
}

ConsensusIndex::ConsensusIndex(std::span<const Eigen::Vector2d> stems_in_map_m)
    : hash_(map_hash(stems_in_map_m)) {
  check_finite(stems_in_map_m);
  centre_m_ = whole_middle(stems_in_map_m);
  grid_ = StemGrid(centred(stems_in_map_m, centre_m_));
  if (grid_.stems().size() < 3) {
    throw UserError(fmt::format("the map has {} stems at {} places; give a map of more stems",
                                stems_in_map_m.size(), grid_.stems().size()));
  }
  groups_ = GroupTable(grid_);
}

}  // namespace honka
