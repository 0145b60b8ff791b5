#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "algo/types/pose.h"

namespace honka::eval {

/// How far an estimated pose is from the truth. Both are ≥ 0.
struct PoseError {
  double translation_m = 0.0;
  double rotation_rad = 0.0;
};

[[nodiscard]] PoseError pose_error(const Pose2& T_map_estimate, const Pose2& T_map_truth);

/// A success: the method accepted the pose *and* the pose is right. The paper prints the first
/// part alone; both are reported.
struct SuccessLimits {
  double translation_m = 0.5;
  double rotation_deg = 2.5;
};

struct Outcome {
  bool accepted = false;  ///< the method's own word
  bool right = false;     ///< within both limits (≤) of the truth
  [[nodiscard]] bool success() const { return accepted && right; }
  [[nodiscard]] bool wrong_pose() const { return accepted && !right; }
};

[[nodiscard]] Outcome judge(bool accepted, const PoseError& error,
                            const SuccessLimits& limits = {});

/// Least standard deviations that an unbiased estimate of (x, y, θ) of the sensor can have.
struct PoseBound {
  Eigen::Matrix3d covariance;  ///< of x, y, θ; metres and radians, in the frame of the stems
  double translation_m = 0.0;  ///< √(var x + var y)
  double rotation_rad = 0.0;   ///< √(var θ)
};

/// Cramér–Rao bound at the sensor from the stems it sees.
///
/// `stems_in_local_m`: their places about the sensor. `sigma_m`: s.d. of the difference between a
/// seen and a mapped stem on each axis, σ² = σ_local² + σ_map², independent between stems. The
/// residual of stem i is e_i = m_i − R(θ) l_i − t, so that with q_i = R l_i the information is
/// σ⁻² Σ [I, Jq_i; (Jq_i)ᵀ, |q_i|²], Jq = (−q_y, q_x): the lever arm of a one-sided view is in it.
/// Nothing for fewer than two distinct stems.
[[nodiscard]] std::optional<PoseBound> cramer_rao_bound(
    std::span<const Eigen::Vector2d> stems_in_local_m, double sigma_m);

/// σ·√(2/N): the bound on translation were the heading known, or the view a full circle. Nothing
/// for N = 0.
[[nodiscard]] std::optional<double> simple_bound_m(double sigma_m, std::int64_t stems);

}  // namespace honka::eval
