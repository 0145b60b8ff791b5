#include "eval/config/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "algo/types/user_error.h"
#include "eval/config/scenario_reader.h"
#include "eval/io/csv.h"
#include "eval/io/table.h"

namespace honka::eval {
namespace fs = std::filesystem;

// Here, because g++ 12 warns of what it sees when it puts so many defaults into every caller.
Scenario::Scenario() = default;

void describe(SettingsVisitor& v, Scenario& s) {
  v.field({"experiment", "", "what is done; honka help experiments", "choice"}, s.experiment, {});
  v.field({"title", "", "of the report", "choice"}, s.title, {});
  v.field({"question", "", "that the experiment answers", "choice"}, s.question, {});
  v.field({"beside", "", "results next to these whose first table the report shows too", "choice"},
          s.beside, {});
  v.field({"seed", "", "of every random number", "choice"}, s.seed, {0, 9007199254740992.0});
  v.field({"trials", "", "stands, each with its own forest and drives", "choice"}, s.trials,
          {1, 1e6});
  v.group("forest", [&] { describe(v, s.forest); });
  v.group("lidar", [&] { describe(v, s.lidar); });
  v.group("harvester", [&] { describe(v, s.harvester); });
  v.group("odometry", [&] { describe(v, s.odometry); });
  v.group("frame", [&] { describe(v, s.frame); });
  v.group("stems", [&] { describe(v, s.stems); });
  v.group("map", [&] { describe(v, s.map); });
  v.group("localize", [&] { describe(v, s.localize); });
  v.group("protocol", [&] { describe(v, s.protocol); });
  v.group("variants", [&] { describe(v, s.variants); });
  v.group("simulate", [&] { describe(v, s.simulate); });
  v.group("stands", [&] { describe(v, s.stands); });
  v.group("slam", [&] {
    describe(v, s.slam_study);  // before the groups of the other: TOML opens a table once
    describe(v, s.slam);
  });
  v.group("link", [&] { describe(v, s.link); });
  v.group("tracking", [&] { describe(v, s.tracking); });
  v.group("options", [&] { describe(v, s.options); });
  v.group("map_update", [&] { describe(v, s.map_update); });
  v.group("sighting", [&] { describe(v, s.sighting); });
  v.group("pairs", [&] { describe(v, s.pairs); });
  v.group("study", [&] { describe(v, s.study); });
}

namespace {

/// Path below the nearest folder called "scenarios", without the extension.
std::string scenario_name(const fs::path& file) {
  const fs::path full = fs::weakly_canonical(file);
  fs::path name = full.stem();
  for (fs::path folder = full.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (folder.filename() == "scenarios") return name.generic_string();
    name = folder.filename() / name;
  }
  return full.stem().string();
}

/// A relative path counts from the present folder, then from the scenario's.
fs::path find_data(const std::string& path, const fs::path& scenario_file) {
  if (fs::exists(path)) return path;
  const fs::path beside = scenario_file.parent_path() / path;
  return fs::exists(beside) ? beside : fs::path(path);
}

std::string place_of(const ResolvedScenario& resolved, const std::string& key) {
  const auto origin = resolved.origins.find(key);
  return origin == resolved.origins.end() ? resolved.file.string() : origin->second;
}

/// A number that stands twice in a list of variants would count its windows twice.
template <class Number>
void check_increasing(const ResolvedScenario& resolved, const std::string& key,
                      const std::vector<Number>& values) {
  const auto falling = std::greater_equal<Number>();
  if (std::adjacent_find(values.begin(), values.end(), falling) == values.end()) return;
  throw UserError(fmt::format("{}: {} must increase, each number once; write it like [1, 3, 5]",
                              place_of(resolved, key), key));
}

void check_protocol(const ResolvedScenario& resolved) {
  const Scenario& scenario = resolved.scenario;
  if (scenario.protocol.frames.empty()) {
    throw UserError(fmt::format("{}: protocol.frames is empty; give at least one number, [1, 3]",
                                place_of(resolved, "protocol.frames")));
  }
  check_increasing(resolved, "protocol.frames", scenario.protocol.frames);
  check_increasing(resolved, "variants.tolerances_m2", scenario.variants.tolerances_m2);
}

/// Lists and maps of experiments have no heights, but for the rows that set this themselves.
void check_stars(const ResolvedScenario& resolved) {
  if (resolved.scenario.localize.li2020.stars == "plane") return;
  const std::string key = "localize.li2020.stars";
  throw UserError(fmt::format(
      "{}: {} = \"space\" asks for stems with heights, which this experiment has not; leave it at "
      "\"plane\": experiment = \"options\" has rows of it on slopes (options.slopes_deg)",
      place_of(resolved, key), key));
}

StemMap read_measured(const ResolvedScenario& resolved) {
  try {
    return read_stem_csv(find_data(resolved.scenario.forest.stem_map, resolved.file));
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: forest.stem_map: {}", place_of(resolved, "forest.stem_map"),
                                error.what()));
  }
}

/// Groups of keys that one kind of experiment alone reads.
struct OwnKeys {
  std::string_view prefix, experiment;
};
constexpr std::array kOwnKeys = {OwnKeys{"tracking.", "tracking"}, OwnKeys{"options.", "options"},
                                 OwnKeys{"map_update.", "map_update"},
                                 OwnKeys{"pairs.", "stem_pairs"}};

/// What a scenario is called, where its data lie, how many trials a study has or how long it waits
/// for one, and the keys of an experiment that is not run do not change the results of a trial.
bool changes_results(const std::string& key, const std::string& experiment) {
  if (key.rfind("study.", 0) == 0) return key == "study.worlds";
  for (const OwnKeys& own : kOwnKeys) {
    if (key.rfind(own.prefix, 0) == 0) return key != "pairs.folder" && experiment == own.experiment;
  }
  return key != "title" && key != "question" && key != "forest.stem_map";
}

std::string hash_of(const Scenario& scenario) {
  std::string text;
  for (const KeyEntry& entry : list_keys(scenario)) {
    if (!changes_results(entry.key, scenario.experiment)) continue;
    text += entry.key + "=" + format_value(entry.value) + "\n";
  }
  if (scenario.measured) {
    for (const Stem& stem : *scenario.measured) {
      text += fmt::format("{},{},{},{}\n", stem.position_m.x(), stem.position_m.y(),
                          stem.dbh_m.value_or(0.0), stem.height_m.value_or(0.0));
    }
  }
  return sha256_hex(text);
}

}  // namespace

namespace {

LocatedValues read_values(const fs::path& file, const std::vector<std::string>& overrides) {
  LocatedValues values = read_toml(file);
  for (const std::string& text : overrides) {
    auto [key, value] = parse_override(text);
    values[key] = std::move(value);
  }
  return values;
}

ResolvedScenario resolve(const fs::path& file, const LocatedValues& values) {
  ResolvedScenario resolved;
  resolved.file = file;
  resolved.name = scenario_name(file);
  ScenarioReader reader(values);
  Scenario& scenario = resolved.scenario;
  describe(reader, scenario);
  reader.check_all_read();
  for (const auto& [key, value] : values) resolved.origins[key] = value.place;
  check_protocol(resolved);
  check_stars(resolved);
  if (!scenario.forest.stem_map.empty()) {
    scenario.measured = read_measured(resolved);
  }
  resolved.hash = hash_of(scenario);
  return resolved;
}

}  // namespace

ResolvedScenario load_scenario(const fs::path& file, const std::vector<std::string>& overrides) {
  LocatedValues values = read_values(file, overrides);
  StudySettings varied;
  take_axes(values, varied);
  ResolvedScenario resolved = resolve(file, values);
  resolved.scenario.study.axes = std::move(varied.axes);
  resolved.scenario.study.fixed = std::move(varied.fixed);
  return resolved;
}

std::vector<StudyPoint> load_study_points(const fs::path& file,
                                          const std::vector<std::string>& overrides) {
  LocatedValues values = read_values(file, overrides);
  StudySettings varied;
  take_axes(values, varied);
  StudySettings study = resolve(file, values).scenario.study;
  study.axes = std::move(varied.axes);
  std::vector<StudyPoint> points;
  for (std::vector<Value>& at : study_points(study)) {
    LocatedValues of_point = values;
    for (std::size_t k = 0; k < at.size(); ++k) {
      of_point[study.axes[k].key] = {at[k], study.axes[k].place, 0, 0};
    }
    points.push_back({std::move(at), resolve(file, of_point)});
    points.back().resolved.scenario.study.axes = study.axes;
  }
  return points;
}

std::vector<KeyEntry> list_keys(const Scenario& scenario) {
  Scenario copy = scenario;
  KeyTable table;
  describe(table, copy);
  return table.entries();
}

namespace {

std::string axis_line(const StudyAxis& axis) {
  std::string text;
  const bool words = std::holds_alternative<std::string>(axis.values.front());
  for (const Value& value : axis.values) {
    text += text.empty() ? "" : ", ";
    text += words ? std::get<std::string>(value) : format_value(value);
  }
  const std::string list = words ? fmt::format("\"{}\"", text) : fmt::format("[{}]", text);
  return fmt::format("{} = {}\n", axis.key, list);
}

}  // namespace

std::string to_toml(const Scenario& scenario) {
  std::string text, group;
  for (const KeyEntry& entry : list_keys(scenario)) {
    const std::size_t dot = entry.key.find_last_of('.');
    const std::string entry_group = dot == std::string::npos ? "" : entry.key.substr(0, dot);
    if (entry_group != group) {
      text += fmt::format("\n[{}]\n", entry_group);
      group = entry_group;
    }
    text += fmt::format("{} = {}\n", entry.key.substr(dot + 1), format_value(entry.value));
  }
  if (!scenario.study.axes.empty()) text += "\n[study.vary]\n";
  for (const StudyAxis& axis : scenario.study.axes) text += axis_line(axis);
  return text;
}

}  // namespace honka::eval
