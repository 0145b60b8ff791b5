#include "algo/odometry/odometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "algo/odometry/loam/loam.h"
#include "algo/odometry/stems/stem_odometry.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using OdometryFactory = std::unique_ptr<Odometry> (*)(const LidarModel&,
                                                      const LidarOdometrySettings&);

struct OdometryEntry {
  std::string_view name;
  OdometryFactory create;
};

// One line for each odometry.
constexpr std::array kOdometries = {
    OdometryEntry{
        "loam",
        [](const LidarModel& model, const LidarOdometrySettings& s) -> std::unique_ptr<Odometry> {
          return std::make_unique<LoamOdometry>(model, s.loam);
        }},
    OdometryEntry{
        "stems",
        [](const LidarModel& model, const LidarOdometrySettings& s) -> std::unique_ptr<Odometry> {
          return std::make_unique<StemOdometry>(model, s.stems);
        }},
};

}  // namespace

std::string_view name_of(OdometryStatus status) {
  constexpr std::array<std::string_view, 4> kNames = {"registered", "degenerate", "predicted",
                                                      "refused"};
  return kNames.at(static_cast<std::size_t>(status));
}

std::string_view name_of(OdometryCause cause) {
  constexpr std::array<std::string_view, 10> kNames = {
      "none",       "gap",          "repeated_time", "reversed_time", "not_finite",
      "empty_scan", "few_features", "unobserved",    "not_converged", "jump"};
  return kNames.at(static_cast<std::size_t>(cause));
}

Eigen::Matrix3d planar_covariance(const OdometryEstimate& estimate) {
  const Pose3& T_odom_end = estimate.T_odom_end;
  const Eigen::Matrix3d R_level_lidar =
      Eigen::AngleAxisd(-yaw_of(T_odom_end), Eigen::Vector3d::UnitZ()) * T_odom_end.linear();
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  J.topLeftCorner<2, 3>() = R_level_lidar.topRows<2>();
  J.bottomRightCorner<1, 3>() = R_level_lidar.row(2);
  const Eigen::Matrix3d planar = J * estimate.covariance * J.transpose();
  return 0.5 * (planar + planar.transpose());
}

void describe(SettingsVisitor& v, LidarOdometrySettings& s) {
  v.group("loam", [&] { describe(v, s.loam); });
  v.group("stems", [&] { describe(v, s.stems); });
}

const std::vector<std::string>& odometry_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const OdometryEntry& entry : kOdometries) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

std::unique_ptr<Odometry> create_odometry(std::string_view name, const LidarModel& model,
                                          const LidarOdometrySettings& settings) {
  const auto* entry = std::find_if(kOdometries.begin(), kOdometries.end(),
                                   [&](const OdometryEntry& e) { return e.name == name; });
  if (entry == kOdometries.end()) {
    throw UserError(fmt::format("no odometry is called \"{}\"; choose one of: {}", name,
                                fmt::join(odometry_names(), ", ")));
  }
  return entry->create(model, settings);
}

}  // namespace honka
