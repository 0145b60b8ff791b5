#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "algo/slam/registration/registration.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// Globally optimal registration of sparse clouds by branch and bound over yaw × x × y.
struct GoIcpSettings {
  std::string mode = "certify";       ///< certify | l0
  double search_yaw_deg = 30.0;       ///< either way about the initial guess
  double search_translation_m = 5.0;  ///< of the sensor, along x and y, either way
  double inlier_share = 0.4;          ///< best part of the source points, 1 − γ
  double gap_m = 0.05;                ///< certify: largest gap in the trimmed RMSE
  double leaf_translation_m = 0.0;    ///< l0: half side of a leaf; 0 is δ0 of the target
  double leaf_yaw_deg = 0.0;          ///< l0: half width of a leaf; 0 is θ0 of the target
  double range_m = 35.0;              ///< l0: R of θ0
  double time_cap_s = 1.0;            ///< wall clock; 0 is off
  std::int64_t node_cap = 0;          ///< boxes bounded; 0 is off. The same digits everywhere
  double share_distance_m = 0.35;     ///< a neighbour nearer than this counts for the share
  double min_share = 0.25;            ///< of the source points in the common view, or refused
  double min_evidence = 20.0;         ///< nats by which partners must be more than chance gives
  bool tilt = true;                   ///< roll, pitch and z by a last fit to the partners
};
void describe(SettingsVisitor& v, GoIcpSettings& s);

/// The pose T_target_source that minimizes the RMSE of the best `inlier_share` of the source
/// points' planar nearest-neighbour distances, over all poses within the search region about the
/// initial guess (whose roll, pitch and z are kept until the last fit). Clouds in metres, any size.
///
/// `lower_bound_m` holds for every pose of the region; certified: nothing there is better than the
/// answer by more than gap_m. The certificate is about the objective: the pose is kRegistered only
/// where the share test holds too, over the source points in the target's cone, or, without one, in
/// the target's convex hull. kTimeCap: a cap was met first; the pose is the best so far.
/// Nevalainen2021, section 2.3, after Yang et al. 2016; see README.md for what differs.
[[nodiscard]] Registration go_icp(std::span<const Eigen::Vector3d> target_m,
                                  std::span<const Eigen::Vector3d> source_m,
                                  const Pose3& T_target_source_initial,
                                  const GoIcpSettings& settings,
                                  const std::optional<ViewCone>& cone = std::nullopt);

}  // namespace honka
