#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/types/pose.h"

namespace honka {

/// A triangle of neighbouring stems in the plane: sides from the longest, and the corners opposite
/// to them.
struct LandmarkTriangle {
  std::array<double, 3> sides_m{};
  std::array<std::uint32_t, 3> corners{};
  bool is_counter_clockwise = false;
};

/// Every triangle of a stem and two of its `neighbours` nearest, once; by the way they turn, then
/// by rising longest side.
[[nodiscard]] std::vector<LandmarkTriangle> landmark_triangles(
    std::span<const Eigen::Vector2d> points_m, std::int64_t neighbours);

/// A pose T_target_source that two triangles speak for.
struct TriangleVote {
  double yaw_rad = 0.0, sine = 0.0, cosine = 1.0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
};

/// The poses that lay a source triangle on a target triangle whose sides differ by
/// at most `tolerance_m` and which turns the same way. Both lists as `landmark_triangles` sorts
/// them. A source triangle that is like very many (a planted grid) votes for the first of them.
[[nodiscard]] std::vector<TriangleVote> triangle_votes(std::span<const Eigen::Vector2d> target_m,
                                                       std::span<const LandmarkTriangle> of_target,
                                                       std::span<const Eigen::Vector2d> source_m,
                                                       std::span<const LandmarkTriangle> of_source,
                                                       double tolerance_m);

/// The planar motion of least squares for pairs of equal index. At least one pair.
[[nodiscard]] Pose2 fit_planar(std::span<const Eigen::Vector2d> target_m,
                               std::span<const Eigen::Vector2d> source_m);

}  // namespace honka
