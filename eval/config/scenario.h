#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algo/localize/matcher.h"
#include "algo/odometry/key_frames.h"
#include "algo/slam/slam.h"
#include "algo/stems/extract.h"
#include "algo/types/settings.h"
#include "algo/types/stem.h"
#include "eval/config/experiment_settings.h"
#include "eval/config/key_table.h"
#include "eval/config/link_study_settings.h"
#include "eval/config/map_update_study_settings.h"
#include "eval/config/options_study_settings.h"
#include "eval/config/sighting_study_settings.h"
#include "eval/config/slam_settings.h"
#include "eval/config/stand_settings.h"
#include "eval/config/study_settings.h"
#include "eval/config/tracking_study_settings.h"
#include "sim/forest/settings.h"
#include "sim/harvester/vehicle_settings.h"
#include "sim/lidar/lidar_settings.h"

namespace honka::eval {

/// One reproducible experiment: all that a scenario file says.
struct Scenario {
  Scenario();

  std::string experiment = "localization";
  std::string title;
  std::string question;
  std::string beside;
  std::int64_t seed = 1;
  std::int64_t trials = 3;
  sim::ForestSettings forest;
  sim::LidarSettings lidar;
  sim::VehicleSettings harvester;
  OdometrySettings odometry;
  KeyFrameSettings frame;
  StemSettings stems;
  MapSettings map;
  LocalizeSettings localize;
  ProtocolSettings protocol;
  VariantSettings variants;
  SimulateSettings simulate;
  StandsSettings stands;
  SlamSettings slam;
  SlamStudySettings slam_study;
  LinkStudySettings link;
  TrackingStudySettings tracking;
  OptionsStudySettings options;
  MapUpdateStudySettings map_update;
  SightingStudySettings sighting;
  StemPairSettings pairs;
  StudySettings study;

  std::optional<StemMap> measured;  ///< what forest.stem_map holds
};

void describe(SettingsVisitor& v, Scenario& s);

/// Where the value of a key came from: "default", "file:line:column" or "-s key=value".
using Origins = std::map<std::string, std::string>;

/// A scenario as it was resolved, with what is needed to show and to cite it.
struct ResolvedScenario {
  Scenario scenario;
  std::string name;  ///< path under scenarios/ without .toml, or the file's stem
  std::filesystem::path file;
  Origins origins;
  /// SHA-256 over every key with its value, and over the measured stem map. What does not change a
  /// trial's results is left out: titles, folders, and how many trials a study has.
  std::string hash;
};

/// Reads a scenario file and the overrides ("key=value") on top of it. UserError as in
/// scenario_reader.h; also where forest.stem_map names no readable stem list.
[[nodiscard]] ResolvedScenario load_scenario(const std::filesystem::path& file,
                                             const std::vector<std::string>& overrides = {});

/// One point of a study: the scenario with one value for each of its axes.
struct StudyPoint {
  std::vector<Value> values;  ///< in the order of the axes
  ResolvedScenario resolved;
};

/// The scenario of each point of a study, in order; one, without values, where nothing varies.
/// UserError as above, with the place of the axis whose value does not fit.
[[nodiscard]] std::vector<StudyPoint> load_study_points(
    const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Every key with value, unit, range, source of the default, in the order of description.
[[nodiscard]] std::vector<KeyEntry> list_keys(const Scenario& scenario);

/// The resolved scenario as a TOML file that reads back to the same settings.
[[nodiscard]] std::string to_toml(const Scenario& scenario);

}  // namespace honka::eval
