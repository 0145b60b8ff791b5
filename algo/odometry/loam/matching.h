#pragma once

#include <vector>

#include "algo/odometry/loam/loam_map.h"
#include "algo/odometry/loam/motion.h"
#include "algo/odometry/loam/registration.h"

namespace honka {

/// Pairs each feature with the line (Zhang2014 Eq. (2)) or plane (Eq. (3)) of the map at its place.
[[nodiscard]] std::vector<LoamMatch> match_features(const LoamFeatures& features,
                                                    const DeskewedFeatures& points,
                                                    const LoamMap& map, const Pose3& T_odom_lidar,
                                                    const LoamRegistrationSettings& settings,
                                                    double azimuth_step_rad);

/// Registers a sweep to the map from `T_odom_guess`, which is also what weak directions follow.
///
/// Each of `rounds` rounds compensates the motion within the sweep by the pose found so far, pairs
/// anew and solves. A pose out of the machine's reach keeps the compensation of the last sweep.
[[nodiscard]] LoamRegistration register_features(const LoamFeatures& features, const LoamMap& map,
                                                 const LoamMotion& motion,
                                                 const Pose3& T_odom_guess, std::int64_t rounds,
                                                 const LoamSettings& settings,
                                                 const LidarModel& model);

/// Twist of one revolution that belongs to a pose: the way from the last sweep, or the last twist
/// where that is out of reach.
[[nodiscard]] Twist sweep_twist(const LoamMotion& motion, const Pose3& T_odom_lidar,
                                const LoamSettings& settings, const LidarModel& model);

}  // namespace honka
