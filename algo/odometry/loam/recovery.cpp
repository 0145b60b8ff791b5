#include "algo/odometry/loam/recovery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka {
namespace {

struct RecoveryCandidate {
  std::int64_t hits = 0;
  std::size_t number = 0;  ///< in the order of the lattice
  Pose3 T_odom_lidar = Pose3::Identity();
};

/// Edges within 30 m: farther ones move off their stems with half a step of heading.
std::vector<Eigen::Vector3d> near_edges(const LoamFeatures& features, const Twist& twist) {
  constexpr double kNear_m = 30.0;
  constexpr std::size_t kMost = 80;
  LoamFeatures near;
  std::copy_if(features.edges.begin(), features.edges.end(), std::back_inserter(near.edges),
               [](const LoamFeature& f) { return f.range_m < kNear_m; });
  near.edges = thinned(near.edges, kMost);
  return deskewed(near.edges, twist);
}

std::vector<RecoveryCandidate> lattice(const std::vector<Eigen::Vector3d>& edges_m,
                                       const FeatureMap& map, const Pose3& T_odom_guess,
                                       double radius_m) {
  constexpr double kStep_m = 0.35;      // of voxels 0.5 m wide
  constexpr double kYawStep_deg = 2.0;  // 0.35 m at 10 m
  constexpr int kYawSteps = 5;
  const int steps = static_cast<int>(std::ceil(radius_m / kStep_m));
  std::vector<RecoveryCandidate> candidates;
  for (int yaw = -kYawSteps; yaw <= kYawSteps; ++yaw) {
    const Eigen::AngleAxisd turn(deg_to_rad(kYawStep_deg * yaw), Eigen::Vector3d::UnitZ());
    std::vector<Eigen::Vector3d> turned;
    for (const Eigen::Vector3d& edge : edges_m) turned.push_back(T_odom_guess * (turn * edge));
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -steps; y <= steps; ++y) {
        const Eigen::Vector3d shift(kStep_m * x, kStep_m * y, 0.0);
        if (shift.norm() > radius_m) continue;
        const auto hits = std::count_if(turned.begin(), turned.end(), [&](const auto& place) {
          return map.holds(place + shift);
        });
        candidates.push_back(
            {hits, candidates.size(), Eigen::Translation3d(shift) * T_odom_guess * Pose3(turn)});
      }
    }
  }
  return candidates;
}

}  // namespace

LoamRegistration recover(const LoamFeatures& features, const LoamMap& map, const LoamMotion& motion,
                         const Pose3& T_odom_guess, const LoamSettings& settings,
                         const LidarModel& model) {
  constexpr std::size_t kTried = 8;
  const auto edges_m = near_edges(features, motion.last_twist);
  auto candidates = lattice(edges_m, map.edges, T_odom_guess, settings.motion.recovery_radius_m);
  const std::size_t tried = std::min(kTried, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(tried),
                    candidates.end(), [](const RecoveryCandidate& a, const RecoveryCandidate& b) {
                      return a.hits != b.hits ? a.hits > b.hits : a.number < b.number;
                    });
  LoamRegistration best;
  best.T_odom_lidar = T_odom_guess;
  for (std::size_t i = 0; i < tried; ++i) {
    const LoamRegistration found =
        register_features(features, map, motion, candidates[i].T_odom_lidar,
                          2 * settings.registration.sweep_rounds, settings, model);
    if (found.edges_close > best.edges_close) best = found;
  }
  return best;
}

}  // namespace honka
