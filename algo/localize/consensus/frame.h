#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace honka {

/// Throws UserError that names the first coordinate not finite.
void check_finite(std::span<const Eigen::Vector2d> stems_m);

/// The local stems about their middle, distinct, from the middle outwards: an
/// order that no order of the list and no motion of the frame changes.
struct LocalFrame {
  std::vector<Eigen::Vector2d> stems_m;
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< subtracted from the list's stems

  /// Least standard deviation over directions: 0 for stems on a line.
  [[nodiscard]] double width_m() const;
  /// Of the stem farthest from the middle.
  [[nodiscard]] double radius_m() const { return stems_m.empty() ? 0.0 : stems_m.back().norm(); }
  /// The `count` stems nearest to `stem`, nearest first, without itself.
  void nearest(std::uint32_t stem, std::size_t count, std::vector<std::uint32_t>& found) const;
};

/// Throws UserError at a coordinate not finite.
[[nodiscard]] LocalFrame make_frame(std::span<const Eigen::Vector2d> stems_in_local_m);

}  // namespace honka
