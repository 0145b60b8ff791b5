#include "sim/harvester/vehicle_settings.h"

namespace honka::sim {
namespace {

void describe_work(SettingsVisitor& v, VehicleSettings& s) {
  v.field({"work_cycle", "", "drive, stop, swing and process stems, drive on; else drives through",
           "choice"},
          s.work_cycle);
  v.field({"least_hop_m", "m", "shortest drive between two stops", "harvesters' work cycle"},
          s.least_hop_m, {0.1, 100.0});
  v.field({"most_hop_m", "m", "longest drive between two stops", "harvesters' work cycle"},
          s.most_hop_m, {0.1, 100.0});
  v.field({"stems_per_stop", "", "stems processed at a stop, one swing each", "choice"},
          s.stems_per_stop, {0, 20});
  v.field({"process_s", "s", "time to fell and process a stem, without swinging", "choice"},
          s.process_s, {0.0, 120.0});
  v.field({"least_swing_deg", "deg", "smallest swing of the view to a stem", "choice"},
          s.least_swing_deg, {0.0, 90.0});
  v.field({"most_swing_deg", "deg", "largest swing of the view to a stem", "choice"},
          s.most_swing_deg, {0.0, 90.0});
  v.field({"swing_rate_deg_s", "deg/s", "fastest swing", "choice: below 15–20"}, s.swing_rate_deg_s,
          {0.1, 60.0});
  v.field({"occluders", "", "crane, boom and the processed tree hide part of the view", "choice"},
          s.occluders);
}

void describe_geometry(SettingsVisitor& v, VehicleSettings& s) {
  v.field(
      {"front_length_m", "m", "from the joint to the front axle", "Komatsu 931: half wheelbase"},
      s.front_length_m, {0.1, 10.0});
  v.field({"rear_length_m", "m", "from the joint to the rear axle", "Komatsu 931: half wheelbase"},
          s.rear_length_m, {0.1, 10.0});
  v.field({"track_width_m", "m", "between the middles of left and right wheels",
           "Komatsu 931: 2.9 m wide"},
          s.track_width_m, {0.1, 5.0});
  v.field({"joint_to_lidar_m", "m", "from the joint ahead to the lidar",
           "Li 2020, figure 2: in front of the windshield"},
          s.joint_to_lidar_m, {-5.0, 10.0});
  v.field(
      {"sensor_height_m", "m",
       "lidar above the ground: the figure that Li 2020 reckons with, not the cabin's top (3.9 m)",
       "Li 2020: 1.5 m, and \"top of the cabin\""},
      s.sensor_height_m, {0.2, 10.0});
  v.field({"mount_roll_deg", "deg", "roll of the lidar on the body", "choice"}, s.mount_roll_deg,
          {-45.0, 45.0});
  v.field(
      {"mount_pitch_deg", "deg", "pitch of the lidar on the body, nose down positive", "choice"},
      s.mount_pitch_deg, {-45.0, 45.0});
  v.field({"suspension_noise_deg", "deg", "roll and pitch of the body on its suspension, 1 sigma",
           "choice"},
          s.suspension_noise_deg, {0.0, 5.0});
}

}  // namespace

void describe(SettingsVisitor& v, VehicleSettings& s) {
  v.field({"drive_speed_m_s", "m/s", "speed between stops; the machine's limit is 8 km/h",
           "Li 2020: 1 m/s on rough ground"},
          s.drive_speed_m_s, {0.01, 2.3});
  v.field({"acceleration_m_s2", "m/s2", "largest acceleration along the path", "choice"},
          s.acceleration_m_s2, {0.05, 5.0});
  describe_work(v, s);
  describe_geometry(v, s);
}

VehicleSettings forwarder_settings() {
  VehicleSettings settings;
  settings.work_cycle = false;
  settings.occluders = false;
  return settings;
}

}  // namespace honka::sim
