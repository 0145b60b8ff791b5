#pragma once

#include <cstdint>

#include "algo/types/settings.h"

namespace honka {

/// Which points of a sweep are features (Zhang2014, section V.A).
struct LoamFeatureSettings {
  double min_range_m = 3.5;
  double max_range_m = 60.0;
  double depth_step_m = 0.3;
  double edge_curvature = 0.03;
  double plane_curvature = 0.004;
  double most_edge_width_m = 1.0;
  std::int64_t sectors = 12;
  std::int64_t planes_per_sector = 4;
};

/// The map of features, voxel by voxel.
struct LoamMapSettings {
  double edge_voxel_m = 0.5;
  double plane_voxel_m = 0.8;
  std::int64_t points_per_voxel = 200;
  std::int64_t most_voxels = 400000;
};

/// Levenberg–Marquardt of a sweep against the map.
struct LoamRegistrationSettings {
  double edge_noise_m = 0.03;
  double plane_noise_m = 0.03;
  double robust_scale = 1.5;
  double gate_m = 0.6;
  double prior_m = 0.03;
  double prior_deg = 0.3;
  double degenerate_sigma_m = 0.1;
  std::int64_t sweep_rounds = 3;
  std::int64_t sweep_features = 150;
  std::int64_t map_rounds = 3;
};

/// What a machine can do between two sweeps, and where to look when it seems to have done more.
struct LoamMotionSettings {
  double jump_m = 0.5;
  double jump_deg = 5.0;
  double most_speed_m_s = 3.0;
  double most_turn_deg_s = 30.0;
  double lost_share = 0.5;
  double recovery_radius_m = 7.0;
};

/// LOAM (Zhang & Singh 2014) in a forest; keys `odometry.loam.*`.
struct LoamSettings {
  LoamFeatureSettings features;
  LoamMapSettings map;
  LoamRegistrationSettings registration;
  LoamMotionSettings motion;
  double key_distance_m = 0.3;
  double key_angle_deg = 30.0;
};

void describe(SettingsVisitor& v, LoamSettings& s);

}  // namespace honka
