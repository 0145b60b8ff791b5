#include "algo/slam/registration/register.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algo/slam/registration/share_test.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

/// What all methods are given.
struct RegistrationTask {
  std::span<const Eigen::Vector3d> target_m, source_m;
  const RegisterSettings& settings;
  const Pose3& initial;
  const std::optional<ViewCone>& cone;
};

Registration by_icp(const RegistrationTask& task) {
  Registration result = trimmed_icp(task.target_m, task.source_m, task.initial, task.settings.icp);
  if (result.status != RegistrationStatus::kRegistered) return result;
  const GoIcpSettings& go = task.settings.go_icp;
  const CommonView view(task.target_m, task.cone, go.share_distance_m);
  judge_share(NearestStems(task.target_m), task.source_m, view,
              {go.share_distance_m, go.min_share, go.min_evidence}, result);
  return result;
}

Registration by_go_icp(const RegistrationTask& task) {
  return go_icp(task.target_m, task.source_m, task.initial, task.settings.go_icp, task.cone);
}

Registration by_landmarks(const RegistrationTask& task) {
  Registration result =
      register_by_landmarks(task.target_m, task.source_m, task.settings.landmarks, task.cone);
  const bool has_pose = result.status == RegistrationStatus::kRegistered ||
                        result.status == RegistrationStatus::kUnverified;
  if (!has_pose) result.T_target_source = task.initial;
  return result;
}

struct RegistrationMethod {
  const char* name;
  Registration (*run)(const RegistrationTask& task);
};

/// A new method is one function and one line here.
constexpr RegistrationMethod kRegistrationMethods[] = {
    {"icp", by_icp}, {"go_icp", by_go_icp}, {"landmarks", by_landmarks}};

}  // namespace

void describe(SettingsVisitor& v, RegisterSettings& s) {
  v.group("icp", [&] { describe(v, s.icp); });
  v.group("go_icp", [&] { describe(v, s.go_icp); });
  v.group("landmarks", [&] { describe(v, s.landmarks); });
}

std::vector<std::string> registration_methods() {
  std::vector<std::string> names;
  for (const RegistrationMethod& method : kRegistrationMethods) names.emplace_back(method.name);
  return names;
}

Registration register_clouds(std::span<const Eigen::Vector3d> target_m,
                             std::span<const Eigen::Vector3d> source_m, const std::string& method,
                             const RegisterSettings& settings, const Pose3& T_target_source_initial,
                             const std::optional<ViewCone>& cone) {
  for (const RegistrationMethod& known : kRegistrationMethods) {
    if (method != known.name) continue;
    if (T_target_source_initial.matrix().allFinite()) {
      return known.run({target_m, source_m, settings, T_target_source_initial, cone});
    }
    Registration refused;
    refused.status = RegistrationStatus::kNotFinite;
    return refused;
  }
  throw UserError(fmt::format("\"{}\" is no registration method; it may be {}", method,
                              fmt::join(registration_methods(), ", ")));
}

}  // namespace honka
