#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algo/slam/registration/landmark_triangles.h"

namespace honka {

/// The middles of the places in pose space (3°, 1 m) with the most votes, the most first, none
/// beside another. At most `count`.
[[nodiscard]] std::vector<Pose2> most_voted(std::span<const TriangleVote> votes, std::size_t count);

}  // namespace honka
