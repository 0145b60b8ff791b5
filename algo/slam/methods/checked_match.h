#pragma once

#include <span>

#include "algo/slam/match_quality.h"
#include "algo/slam/registration/trimmed_icp.h"
#include "algo/slam/view_cone.h"

namespace honka {

/// How two frames are matched, and when the match counts.
struct MatchRules {
  double inlier_ratio = 0.4;
  double polish_distance_m = 0.4;
  double min_share = 0.5;
  ViewCone cone;
  MatchQualitySettings quality;
};

/// A match and what the share test says of it. The pose is finite.
struct CheckedMatch {
  Pose3 T_target_source = Pose3::Identity();
  MatchQuality quality;
  bool passed = false;
};

/// A frame that others are matched to. `points_m` must outlive it and be finite.
class MatchTarget {
 public:
  explicit MatchTarget(std::span<const Eigen::Vector3d> points_m);

  /// Whether it holds three distinct points not on one line.
  [[nodiscard]] bool registrable() const { return registrable_; }

  /// Trimmed ICP from the guess, a polish with all near pairs, the share test. A source or a target
  /// that cannot be registered does not pass; the pose is then the guess.
  [[nodiscard]] CheckedMatch match(std::span<const Eigen::Vector3d> source_m,
                                   const Pose3& T_target_source_guess,
                                   const MatchRules& rules) const;

  /// The share test of a pose found elsewhere, after the same polish.
  [[nodiscard]] CheckedMatch check(std::span<const Eigen::Vector3d> source_m,
                                   const Pose3& T_target_source, const MatchRules& rules) const;

  /// RMSE of the nearest `inlier_ratio` of the source points, in the plane.
  [[nodiscard]] double trimmed_error_m(std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source, double inlier_ratio) const;

 private:
  [[nodiscard]] Pose3 polished(std::span<const Eigen::Vector3d> source_m, Pose3 pose,
                               double distance_m) const;

  std::span<const Eigen::Vector3d> points_m_;
  NearestStems search_;
  bool registrable_ = false;
};

}  // namespace honka
