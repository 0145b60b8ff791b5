#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/registration/go_icp.h"
#include "algo/slam/registration/landmark_voting.h"
#include "algo/slam/registration/trimmed_icp.h"

namespace honka {

/// Settings of every registration of two sparse clouds.
struct RegisterSettings {
  TrimmedIcpSettings icp;
  GoIcpSettings go_icp;
  LandmarkVotingSettings landmarks;
};
void describe(SettingsVisitor& v, RegisterSettings& s);

/// icp | go_icp | landmarks, in this order.
[[nodiscard]] std::vector<std::string> registration_methods();

/// One door to all of them: T_target_source of two sparse clouds in metres, by the method named.
/// `landmarks` needs no initial guess and leaves it aside, but where it cannot answer. Whatever the
/// method, the pose is finite, and kRegistered says that it passed the share test of go_icp's or
/// landmarks' settings (icp: go_icp's). UserError for a method that does not exist; everything else
/// that fails is a status.
[[nodiscard]] Registration register_clouds(std::span<const Eigen::Vector3d> target_m,
                                           std::span<const Eigen::Vector3d> source_m,
                                           const std::string& method,
                                           const RegisterSettings& settings,
                                           const Pose3& T_target_source_initial,
                                           const std::optional<ViewCone>& cone = std::nullopt);

}  // namespace honka
