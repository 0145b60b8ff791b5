#include "algo/odometry/loam/matching.h"

#include <Eigen/Geometry>
#include <cmath>

#include "algo/odometry/loam/rings.h"

namespace honka {
namespace {

/// Nothing where no line is near enough.
void match_edge(const Eigen::Vector3d& point, double grain_m, const FeatureMap& map,
                const Pose3& T_odom_lidar, const LoamRegistrationSettings& settings,
                std::vector<LoamMatch>& matches) {
  const Eigen::Vector3d place = T_odom_lidar * point;
  const auto line = map.line_at(place);
  if (!line) return;
  const Eigen::Vector3d offset = place - line->centre_m;
  const Eigen::Vector3d across = offset - line->direction.dot(offset) * line->direction;
  if (across.squaredNorm() > settings.gate_m * settings.gate_m) return;
  const double sigma_m = std::sqrt(settings.edge_noise_m * settings.edge_noise_m +
                                   grain_m * grain_m + line->variance_m2);
  LoamMatch match{point, line->centre_m, {}, true};
  const Eigen::Vector3d first = line->direction.unitOrthogonal();
  match.normals.row(0) = first / sigma_m;
  match.normals.row(1) = line->direction.cross(first) / sigma_m;
  matches.push_back(match);
}

void match_plane(const Eigen::Vector3d& point, const FeatureMap& map, const Pose3& T_odom_lidar,
                 const LoamRegistrationSettings& settings, std::vector<LoamMatch>& matches) {
  const Eigen::Vector3d place = T_odom_lidar * point;
  const auto plane = map.plane_at(place);
  if (!plane) return;
  const double off_m = plane->direction.dot(place - plane->centre_m);
  if (std::abs(off_m) > settings.gate_m) return;
  const double sigma_m =
      std::sqrt(settings.plane_noise_m * settings.plane_noise_m + plane->variance_m2);
  LoamMatch match{point, plane->centre_m, {}, false};
  match.normals.row(0) = plane->direction / sigma_m;
  match.normals.row(1).setZero();
  matches.push_back(match);
}

void count_matches(const std::vector<LoamMatch>& matches, LoamRegistration& result) {
  constexpr double kClose = 9.0;  // three s.d., squared
  result.edges_matched = result.edges_close = result.planes_matched = 0;
  for (const LoamMatch& match : matches) {
    if (!match.edge) {
      ++result.planes_matched;
      continue;
    }
    ++result.edges_matched;
    const double squared = match_residual(match, result.T_odom_lidar).squaredNorm();
    if (squared < kClose) ++result.edges_close;
  }
}

}  // namespace

std::vector<LoamMatch> match_features(const LoamFeatures& features, const DeskewedFeatures& points,
                                      const LoamMap& map, const Pose3& T_odom_lidar,
                                      const LoamRegistrationSettings& settings,
                                      double azimuth_step_rad) {
  std::vector<LoamMatch> matches;
  matches.reserve(points.edges_m.size() + points.planes_m.size());
  for (std::size_t i = 0; i < points.edges_m.size(); ++i) {
    match_edge(points.edges_m[i], edge_grain_m(features.edges[i].range_m, azimuth_step_rad),
               map.edges, T_odom_lidar, settings, matches);
  }
  for (const Eigen::Vector3d& point : points.planes_m) {
    match_plane(point, map.planes, T_odom_lidar, settings, matches);
  }
  return matches;
}

Twist sweep_twist(const LoamMotion& motion, const Pose3& T_odom_lidar, const LoamSettings& settings,
                  const LidarModel& model) {
  return motion.allows(T_odom_lidar, settings.motion, model.sweep_period_s())
             ? motion.twist_to(T_odom_lidar)
             : motion.last_twist;
}

LoamRegistration register_features(const LoamFeatures& features, const LoamMap& map,
                                   const LoamMotion& motion, const Pose3& T_odom_guess,
                                   std::int64_t rounds, const LoamSettings& settings,
                                   const LidarModel& model) {
  LoamRegistration result;
  result.T_odom_lidar = T_odom_guess;
  result.edges_offered = features.edges.size();
  for (std::int64_t round = 0; round < rounds; ++round) {
    const DeskewedFeatures points(features,
                                  sweep_twist(motion, result.T_odom_lidar, settings, model));
    const auto matches = match_features(features, points, map, result.T_odom_lidar,
                                        settings.registration, azimuth_step_rad(model));
    solve_matches(matches, T_odom_guess, settings.registration, result);
    count_matches(matches, result);
  }
  return result;
}

}  // namespace honka
