#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eval/metrics/trajectory_pairs.h"

namespace honka::eval {

/// What may move the estimate onto the truth before their poses are compared.
enum class Alignment {
  kNone,
  kOrigin,  ///< the first pair of poses made equal
  kYaw,     ///< turn about z and translation: 4 degrees of freedom
  kSe2,     ///< turn about z, x and y: heights stay as they are
  kSe3,     ///< rotation and translation
  kSim3,    ///< and scale
};

/// none, origin, yaw, se2, se3, sim3.
[[nodiscard]] std::vector<std::string> alignment_names();
[[nodiscard]] std::string alignment_name(Alignment alignment);
[[nodiscard]] std::optional<Alignment> alignment_of(std::string_view name);

/// p_truth = scale · R p_estimate + t.
struct Similarity3 {
  double scale = 1.0;
  Pose3 rigid = Pose3::Identity();  ///< R and t

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rigid.linear() * point) + rigid.translation();
  }
  /// The pose moved with its world: the position scaled, the rotation turned.
  [[nodiscard]] Pose3 operator*(const Pose3& pose) const;
};

enum class AlignmentStatus {
  kAligned,
  kNoPairs,
  kNoRotations,  ///< origin: a side knows positions alone
  kNoExtent,     ///< positions at one place (yaw, se2: in plan), or without a common direction
  kCollinear,    ///< se3, sim3: the turn about the line is free
};

/// One clause in words, such as "the positions lie on a line, …".
[[nodiscard]] std::string alignment_problem(AlignmentStatus status);

struct AlignmentResult {
  AlignmentStatus status = AlignmentStatus::kAligned;
  Similarity3 T_truth_estimate;  ///< identity unless aligned
};

/// The transform that brings the estimated positions nearest to the true ones in the sense of least
/// squares (Umeyama 1991, Eqs. (34)–(42); in plan its closed form), or, for kOrigin, the first
/// estimated pose onto the first true one. Rotations are read by kOrigin alone.
[[nodiscard]] AlignmentResult align(const PosePairs& pairs, Alignment alignment);

/// The pairs with the estimates moved.
[[nodiscard]] PosePairs moved(PosePairs pairs, const Similarity3& T_truth_estimate);

}  // namespace honka::eval
