#pragma once

#include <cstdint>

#include "algo/types/settings.h"

namespace honka {

/// Error of odometry: drift, and a random walk along the way, with the turns, and with time. The
/// walk is for odometries that state no covariance.
struct OdometryNoiseSettings {
  double sigma_m_per_sqrt_m = 0.03;
  double sigma_deg_per_sqrt_m = 0.1;
  double sigma_deg_per_sqrt_turn = 0.3;
  double sigma_m_per_sqrt_s = 0.005;
  double sigma_deg_per_sqrt_s = 0.02;
  double drift = 0.0007;
  double drift_length_m = 100.0;
  double unobserved_m_per_s = 0.5;
  double unobserved_deg_per_s = 10.0;
};
void describe(SettingsVisitor& v, OdometryNoiseSettings& s);

/// How odometry and localizations become a track.
struct TrackingSettings {
  OdometryNoiseSettings odometry;
  double fix_sigma_m = 0.2;
  double fix_sigma_deg = 1.0;
  double map_sigma_m = 0.01;
  double map_sigma_deg = 0.0;
  double shared_length_m = 10.0;
  double gate_probability = 0.999;
  std::int64_t confirm_fixes = 3;
  double confirm_distance_m = 0.5;
  double kidnapped_beyond_m = 2.0;
  std::int64_t lost_after = 5;
  double coasting_after_s = 5.0;
  std::int64_t prior_misses = 3;
  double prior_floor_m = 1.0;

  /// That fixes of an undisturbed track, independent and of the stated covariance, are taken for a
  /// kidnapping at a given fix: the last `confirm_fixes` of them all outside the gate.
  [[nodiscard]] double false_alarm_probability() const;
};
void describe(SettingsVisitor& v, TrackingSettings& s);

}  // namespace honka
