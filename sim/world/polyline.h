#pragma once

#include <Eigen/Core>
#include <vector>

namespace honka::sim {

/// A path in the plane by its corners, in order. Metres.
using Polyline = std::vector<Eigen::Vector2d>;

[[nodiscard]] double length_m(const Polyline& line);
/// The point `along_m` after the start, on the line; the nearest end outside [0, length].
[[nodiscard]] Eigen::Vector2d point_at(const Polyline& line, double along_m);
/// Shortest distance from `point_m` to the line; infinite for an empty line.
[[nodiscard]] double distance_m(const Polyline& line, const Eigen::Vector2d& point_m);
/// Points every `step_m` along the line, both ends included.
[[nodiscard]] Polyline resampled(const Polyline& line, double step_m);

}  // namespace honka::sim
