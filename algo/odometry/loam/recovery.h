#pragma once

#include <vector>

#include "algo/odometry/loam/matching.h"

namespace honka {

/// Looks for the sweep around a guess: poses on a lattice of places and headings are judged by how
/// many edges fall on edges of the map, the best are registered, and the one with the most edges
/// close to their lines is the answer. Some 30 ms; for sweeps that fit nowhere near the guess.
[[nodiscard]] LoamRegistration recover(const LoamFeatures& features, const LoamMap& map,
                                       const LoamMotion& motion, const Pose3& T_odom_guess,
                                       const LoamSettings& settings, const LidarModel& model);

}  // namespace honka
