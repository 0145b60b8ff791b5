#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "algo/slam/registration/register.h"
#include "algo/types/user_error.h"
#include "eval/cli/verbs.h"
#include "eval/io/cloud_csv.h"

namespace honka::eval {
namespace {

nlohmann::ordered_json registration_answer(const RegisterArguments& arguments,
                                           const Registration& result, double time_ms) {
  nlohmann::ordered_json json;
  json["method"] = arguments.method;
  json["status"] = registration_status_name(result.status);
  std::vector<double> rows;
  for (Eigen::Index k = 0; k < 16; ++k) rows.push_back(result.T_target_source(k / 4, k % 4));
  json["T_target_source"] = rows;
  json["rmse_m"] = result.rmse_m;
  json["overlap"] = result.overlap;
  json["inliers"] = result.inliers;
  json["share"] = result.share;
  json["lower_bound_m"] = result.lower_bound_m;
  json["gap_m"] = result.gap_m;
  json["certified"] = result.certified;
  json["nodes"] = result.nodes;
  json["time_ms"] = time_ms;
  return json;
}

void print_registration(const RegisterArguments& arguments, const Registration& result,
                        double time_ms) {
  const Eigen::Vector3d t = result.T_target_source.translation();
  fmt::print("{}: {}, x {:.3f} m, y {:.3f} m, z {:.3f} m, yaw {:.5f} rad\n", arguments.method,
             registration_status_name(result.status), t.x(), t.y(), t.z(),
             yaw_of(result.T_target_source));
  fmt::print("rmse {:.3f} m, {} inliers, share {:.2f}", result.rmse_m, result.inliers,
             result.share);
  if (arguments.method == "go_icp") {
    fmt::print(", lower bound {:.3f} m, {}certified, {} nodes", result.lower_bound_m,
               result.certified ? "" : "not ", result.nodes);
  }
  fmt::print(", {:.1f} ms\n", time_ms);
}

}  // namespace

int register_verb(const RegisterArguments& arguments) {
  if (!(arguments.inlier_share > 0.0 && arguments.inlier_share <= 1.0)) {
    throw UserError("--inlier-share: must be above 0 and at most 1, such as 0.4");
  }
  RegisterSettings settings;
  settings.icp.inlier_ratio = arguments.inlier_share;
  settings.go_icp.inlier_share = arguments.inlier_share;
  settings.go_icp.mode = arguments.mode;
  settings.landmarks.inlier_share = arguments.inlier_share;
  const auto target_m = read_cloud_csv(arguments.target);
  const auto source_m = read_cloud_csv(arguments.source);

  const auto start = std::chrono::steady_clock::now();
  const Registration result =
      register_clouds(target_m, source_m, arguments.method, settings, Pose3::Identity());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  if (arguments.json) {
    fmt::print("{}\n", registration_answer(arguments, result, time.count()).dump());
  } else {
    print_registration(arguments, result, time.count());
  }
  return 0;
}

}  // namespace honka::eval
