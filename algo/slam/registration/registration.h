#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "algo/types/pose.h"

namespace honka {

enum class RegistrationStatus : std::uint8_t {
  kRegistered,    ///< the pose can be used
  kTooFewPoints,  ///< fewer than three distinct points in a cloud, or all on one line
  kNotFinite,     ///< a cloud holds NaN or infinity
  kUnverified,    ///< a pose was found and failed the share test
  kTimeCap,       ///< the search ended before its certificate; the pose is the best so far
};

/// registered | too_few_points | not_finite | unverified | time_cap
[[nodiscard]] std::string_view registration_status_name(RegistrationStatus status);

/// How two sparse clouds were laid onto each other. Where the status is kTooFewPoints or kNotFinite
/// the pose is the initial guess. The pose is always finite.
struct Registration {
  RegistrationStatus status = RegistrationStatus::kTooFewPoints;
  Pose3 T_target_source = Pose3::Identity();
  double rmse_m = 0.0;         ///< over the inlier share of nearest-neighbour distances
  double overlap = 0.0;        ///< λ of the view cones; 1 where no cone was given
  int inliers = 0;             ///< source points with a partner under the share distance
  double share = 0.0;          ///< of the overlap's source points with such a partner
  double lower_bound_m = 0.0;  ///< of the trimmed RMSE; global methods only
  double gap_m = 0.0;          ///< rmse of the objective − lower bound; global methods only
  bool certified = false;      ///< the gap is within its tolerance
  std::int64_t nodes = 0;      ///< visited by branch and bound
  int iterations = 0;          ///< of ICP

  [[nodiscard]] bool usable() const { return status == RegistrationStatus::kRegistered; }
};

}  // namespace honka
