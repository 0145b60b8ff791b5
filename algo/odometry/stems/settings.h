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

/// The odometry on stems: keys odometry.stems.*.
struct StemOdometrySettings {
  StemPointSettings points;
};
void describe(SettingsVisitor& v, StemOdometrySettings& s);

}  // namespace honka
