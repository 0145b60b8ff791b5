#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace honka::sim {

/// Statistics of how stems stand to each other in a rectangular window. Metres. All need at least
/// two stems and a window with an area (a check ends the program otherwise).

/// Mean distance to the nearest other stem, without correction for the window's border.
[[nodiscard]] double mean_nearest_neighbour_m(const std::vector<Eigen::Vector2d>& stems_m,
                                              const Eigen::AlignedBox2d& window_m);

/// Clark–Evans index: mean nearest-neighbour distance over that of complete randomness, with
/// Donnelly's correction for the window's border (Donnelly1978). 1 random, above regular.
[[nodiscard]] double clark_evans(const std::vector<Eigen::Vector2d>& stems_m,
                                 const Eigen::AlignedBox2d& window_m);

/// Pair correlation g at each of `radii_m`: density of pairs at that distance (± `half_width_m`,
/// box kernel, translation correction) over that of complete randomness (Ohser1983).
[[nodiscard]] std::vector<double> pair_correlation(const std::vector<Eigen::Vector2d>& stems_m,
                                                   const Eigen::AlignedBox2d& window_m,
                                                   const std::vector<double>& radii_m,
                                                   double half_width_m);

}  // namespace honka::sim
