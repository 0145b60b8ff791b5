#include "sim/lidar/lidar_settings.h"

#include <array>
#include <string_view>

#include "algo/types/angles.h"
#include "algo/types/user_error.h"

namespace honka::sim {
namespace {

/// A spinning lidar with evenly spaced rings that fires all its lasers in turn.
LidarModel even_rings(std::string_view name, int lasers, double lowest_deg, double highest_deg,
                      double firing_period_s, double max_range_m) {
  LidarModel model;
  model.name = name;
  model.firing_period_s = firing_period_s;
  model.range_resolution_m = 0.002;
  model.max_range_m = max_range_m;
  for (int id = 0; id < lasers; ++id) {
    const double share = static_cast<double>(id) / (lasers - 1);
    model.lasers.push_back({deg_to_rad(lowest_deg + share * (highest_deg - lowest_deg)), 0.0,
                            firing_period_s * static_cast<double>(id) / lasers});
  }
  return model;
}

struct Entry {
  std::string_view name;
  LidarModel (*make)(const LidarSettings&);
};

/// One line a sensor: the name in scenario files and its table.
constexpr std::array<Entry, 3> kModels = {{
    {"vlp16", [](const LidarSettings& s) { return vlp16(s.rotation_rate_hz, s.vertical_offsets); }},
    // Velodyne HDL-32E manual: +10.67 to −30.67 degrees, a firing every 46.08 µs.
    {"hdl32",
     [](const LidarSettings&) { return even_rings("hdl32", 32, -30.67, 10.67, 46.08e-6, 100.0); }},
    // Ouster OS1-64 data sheet: 45 degrees in 64 rings; 2,048 columns a revolution at 10 Hz.
    {"os64",
     [](const LidarSettings&) { return even_rings("os64", 64, -22.5, 22.5, 48.828e-6, 120.0); }},
}};

Choices model_names() {
  Choices names;
  for (const Entry& entry : kModels) names.emplace_back(entry.name);
  return names;
}

void describe_beam(SettingsVisitor& v, LidarSettings& s) {
  v.field({"divergence_horizontal_mrad", "mrad", "full 1/e² divergence along the azimuth",
           "HDL-64E manual; the VLP-16's own was not found"},
          s.divergence_horizontal_mrad, {0.0, 20.0});
  v.field({"divergence_vertical_mrad", "mrad", "full 1/e² divergence across the azimuth",
           "HDL-64E manual; the VLP-16's own was not found"},
          s.divergence_vertical_mrad, {0.0, 20.0});
  v.field({"sub_rays", "", "rays traced a shot, over its footprint: 1, 5 or 9", "choice"},
          s.sub_rays, {1, 9});
  v.field({"pulse_resolution_m", "m", "sub-rays closer than this in range melt into one echo",
           "choice: half the length of a 2.7 ns pulse"},
          s.pulse_resolution_m, {0.0, 5.0});
  v.field({"return_mode", "", "which echo of a shot is reported", "VLP-16 manual 63-9243"},
          s.return_mode, {"strongest", "last", "dual"});
  v.field({"drop_out", "", "share of shots that get lost at any range", "choice"}, s.drop_out,
          {0.0, 1.0});
  v.field({"half_detection_range_m", "m",
           "range at which half the shots on a 10 % target come back; 0 = all do", "choice"},
          s.half_detection_range_m, {0.0, 1000.0});
}

}  // namespace

void describe(SettingsVisitor& v, LidarSettings& s) {
  v.field({"model", "", "sensor whose laser and firing table is used", "VLP-16 manual 63-9243"},
          s.model, model_names());
  v.field({"rotation_rate_hz", "Hz",
           "revolutions a second (the papers' 30 Hz does not exist on this sensor)",
           "VLP-16 manual 63-9243: 5–20"},
          s.rotation_rate_hz, {5.0, 20.0});
  v.field({"field_of_view_deg", "deg", "seen sector about the x axis; the machine hides the rest",
           "Li 2020"},
          s.field_of_view_deg, {1.0, 360.0});
  v.field(
      {"vertical_offsets", "", "beams start at their lasers' own heights", "VLP-16 manual 63-9243"},
      s.vertical_offsets);
  v.field({"min_range_m", "m", "nearer surfaces give no return", "choice"}, s.min_range_m,
          {0.0, 10.0});
  v.field({"max_range_m", "m", "farther surfaces give no return", "VLP-16 manual 63-9243"},
          s.max_range_m, {1.0, 131.0});
  v.field({"range_noise_m", "m", "repeatability of a range, 1 sigma",
           "measured on real units: 7–15 mm"},
          s.range_noise_m, {0.0, 1.0});
  v.field({"range_bias_m", "m", "each laser's own bias is uniform in plus or minus this",
           "VLP-16 manual 63-9243: accuracy ±3 cm"},
          s.range_bias_m, {0.0, 1.0});
  describe_beam(v, s);
}

LidarModel make_lidar_model(const LidarSettings& settings) {
  for (const Entry& entry : kModels) {
    if (entry.name != settings.model) continue;
    LidarModel model = entry.make(settings);
    model.rotation_rate_hz = settings.rotation_rate_hz;
    model.max_range_m = settings.max_range_m;
    return model;
  }
  std::string message = "lidar.model: no sensor is called \"" + settings.model + "\"; known are:";
  for (const Entry& entry : kModels) message.append(" ").append(entry.name);
  throw UserError(message);
}

}  // namespace honka::sim
