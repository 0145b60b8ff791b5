#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace honka {

/// A tree stem as a landmark in the plane of its map or local frame. Metres.
struct Stem {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  std::optional<double> z_m;       ///< ground height at the stem
  std::optional<double> dbh_m;     ///< diameter at breast height (1.3 m)
  std::optional<double> height_m;  ///< of the tree
  int observations = 0;            ///< points (or frames) that stand behind it

  bool operator==(const Stem&) const = default;
};

using StemMap = std::vector<Stem>;

}  // namespace honka
