#pragma once

#include <cstdint>

#include "algo/types/settings.h"

namespace honka {

/// What counts as a stem in one sweep.
struct StemPointSettings {
  double min_range_m = 3.5;
  double max_range_m = 40.0;
  double range_jump_m = 0.15;
  double background_m = 0.3;
  double max_width_m = 0.8;
  std::int64_t min_rings = 3;
  double min_span_m = 0.8;
  double max_lean_deg = 20.0;
  double max_bend_m = 0.05;
  double range_sigma_m = 0.03;
};
void describe(SettingsVisitor& v, StemPointSettings& s);

/// How the direction of gravity is read from scans.
struct VerticalSettings {
  std::int64_t min_stems = 5;
  double merge_m = 0.5;
  double ground_range_m = 15.0;
  double ground_slope_deg = 3.0;
  StemPointSettings points;
};
void describe(SettingsVisitor& v, VerticalSettings& s);

/// The ground under the near returns, and the map of it.
struct StemGroundSettings {
  std::int64_t firing_step = 12;
  double max_range_m = 20.0;
  double max_slope_deg = 25.0;
  double cell_m = 1.0;
  std::int64_t cells = 256;
  double tolerance_m = 0.25;
  double sigma_m = 0.06;
};
void describe(SettingsVisitor& v, StemGroundSettings& s);

/// The map of stems as landmarks.
struct StemLandmarkSettings {
  double key_distance_m = 0.3;
  double key_angle_deg = 5.0;
  double radius_m = 45.0;
  double apart_m = 0.8;
  double lean_deg = 2.0;
  double sigma_m = 0.02;
  double slope_sigma_deg = 0.5;
  std::int64_t confirm = 3;
  std::int64_t forget_key_frames = 30;
  std::int64_t max_landmarks = 20000;
};
void describe(SettingsVisitor& v, StemLandmarkSettings& s);

/// Registration of one sweep, and what the machine can do between two.
struct StemRegistrationSettings {
  double gate_m = 0.5;
  std::int64_t min_stems = 3;
  double min_share = 0.3;
  double acceleration_m_s2 = 0.5;
  double turn_acceleration_deg_s2 = 15.0;
  double degenerate_m = 0.3;
  double degenerate_deg = 3.0;
  double search_m = 8.0;
  double search_deg = 20.0;
  std::int64_t restart_sweeps = 3;
};
void describe(SettingsVisitor& v, StemRegistrationSettings& s);

/// The odometry on stems: keys odometry.stems.*.
struct StemOdometrySettings {
  StemPointSettings points;
  StemGroundSettings ground;
  StemLandmarkSettings landmarks;
  StemRegistrationSettings registration;
};
void describe(SettingsVisitor& v, StemOdometrySettings& s);

}  // namespace honka
