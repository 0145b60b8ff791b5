#include "algo/localize/tracking/settings.h"

#include <cmath>

namespace honka {

void describe(SettingsVisitor& v, OdometryNoiseSettings& s) {
  v.field({"drift", "", "s.d. of the drift of x and of y, metres a metre of way",
           "scenarios/odometry: up to 0.1 % of the way, on two axes"},
          s.drift, {0, 1});
  v.field(
      {"drift_length_m", "m", "way over which the drift holds", "choice: drift is given per 100 m"},
      s.drift_length_m, {0.01, 1e6});
  v.field({"unobserved_m_per_s", "m/s", "s.d. of the motion that no registration saw",
           "choice: half of a forwarder's speed"},
          s.unobserved_m_per_s, {0, 100});
  v.field({"unobserved_deg_per_s", "deg/s", "the same of the turn", "choice"},
          s.unobserved_deg_per_s, {0, 1000});
  v.field({"sigma_m_per_sqrt_m", "m",
           "of an odometry that states no covariance: s.d. of x and of y after one metre",
           "choice: 0.3 m after 100 m, the class of lidar odometry"},
          s.sigma_m_per_sqrt_m, {0, 10});
  v.field({"sigma_deg_per_sqrt_m", "deg", "s.d. of yaw after one metre",
           "choice: 1 deg after 100 m, as above"},
          s.sigma_deg_per_sqrt_m, {0, 90});
  v.field({"sigma_deg_per_sqrt_turn", "deg", "s.d. of yaw after a turn of one radian",
           "choice: swings of the crane's cabin are fast"},
          s.sigma_deg_per_sqrt_turn, {0, 90});
  v.field({"sigma_m_per_sqrt_s", "m", "s.d. of x and of y after one second at rest",
           "choice: 0.04 m a minute"},
          s.sigma_m_per_sqrt_s, {0, 10});
  v.field({"sigma_deg_per_sqrt_s", "deg", "s.d. of yaw after one second at rest",
           "choice: 0.15 deg a minute"},
          s.sigma_deg_per_sqrt_s, {0, 90});
}

void describe(SettingsVisitor& v, TrackingSettings& s) {
  v.group("odometry", [&] { describe(v, s.odometry); });
  v.field({"fix_sigma_m", "m", "s.d. of x and of y of a localization that states no covariance",
           "Li2020 3.2: error 0.2 m, s.d. 0.14 m"},
          s.fix_sigma_m, {1e-6, 100});
  v.field({"fix_sigma_deg", "deg", "s.d. of yaw of a localization that states no covariance",
           "Li2020 3.2: at most 2.23 deg"},
          s.fix_sigma_deg, {1e-6, 90});
  v.field({"map_sigma_m", "m",
           "what residuals do not show of any fix: level of its frame, bend of the map",
           "choice: 0.2 deg of level (algo/odometry/stems) at 3 m of height"},
          s.map_sigma_m, {0, 100});
  v.field({"map_sigma_deg", "deg", "the same of yaw", "choice"}, s.map_sigma_deg, {0, 90});
  v.field(
      {"shared_length_m", "m",
       "way over which the same stems are seen: fixes count as one, registrations share an error",
       "choice: a third of the 30 m of sight"},
      s.shared_length_m, {0.01, 1000});
  v.field({"gate_probability", "", "of a fix of the stated covariance to be inside the gate",
           "choice: chi-square, 3 degrees of freedom"},
          s.gate_probability, {0.5, 0.999999});
  v.field({"confirm_fixes", "", "fixes that agree by odometry, to begin, move or recover a track",
           "choice: false alarms (1 - gate_probability)^3"},
          s.confirm_fixes, {1, 100});
  v.field({"confirm_distance_m", "m", "way between them: the same view repeats its mistake",
           "choice: more than the 0.3 m between key frames"},
          s.confirm_distance_m, {0, 100});
  v.field({"kidnapped_beyond_m", "m", "an agreed move of less is a correction of the track",
           "choice: far beyond the error of a fix"},
          s.kidnapped_beyond_m, {0, 1e6});
  v.field({"lost_after", "", "fixes in a row outside the gate that end a track", "choice"},
          s.lost_after, {1, 1000});
  v.field({"coasting_after_s", "s", "without a fix", "choice"}, s.coasting_after_s, {0, 1e6});
  v.field({"prior_misses", "", "refusals or rejections in a row after which all the map is asked",
           "choice"},
          s.prior_misses, {1, 1000});
  v.field({"prior_floor_m", "m", "added to 3 s.d. of the position for the next prior's radius",
           "choice"},
          s.prior_floor_m, {0.01, 1000});
}

double TrackingSettings::false_alarm_probability() const {
  return std::pow(1.0 - gate_probability, static_cast<double>(confirm_fixes));
}

}  // namespace honka
