#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "eval/cli/verbs.h"
#include "eval/config/scenario.h"
#include "eval/run/experiment.h"
#include "eval/study/study.h"

namespace honka::eval {
namespace {

ResolvedScenario load(const ScenarioArguments& arguments) {
  ResolvedScenario resolved = load_scenario(arguments.scenario, arguments.all_overrides());
  static_cast<void>(find_experiment(resolved));
  return resolved;
}

std::string allowed(const KeyEntry& entry) {
  if (!entry.choices.empty()) {
    std::string text;
    for (const std::string& choice : entry.choices) text += (text.empty() ? "" : " | ") + choice;
    return text;
  }
  const auto [low, high] = entry.range;
  if (std::isinf(low) && std::isinf(high)) return "";
  return fmt::format("{} to {}", low, std::isinf(high) ? "any" : fmt::format("{}", high));
}

}  // namespace

std::vector<std::string> ScenarioArguments::all_overrides() const {
  std::vector<std::string> all = overrides;
  if (seed) all.push_back(fmt::format("seed={}", *seed));
  return all;
}

int scenario_check_verb(const ScenarioArguments& arguments) {
  const ResolvedScenario resolved = load(arguments);
  const std::string file = arguments.scenario.string();
  fmt::print("{}: well formed; {} keys set, hash {}\n", file, resolved.origins.size(),
             resolved.hash.substr(0, 12));
  if (!resolved.scenario.study.asked_for()) {
    fmt::print("Run it: honka run {}\n", file);
    return 0;
  }
  const Study study = load_study(arguments.scenario, arguments.all_overrides());
  fmt::print("A study: {} points, {} trials each\nRun it: honka study {}\n", study.points.size(),
             study.trials, file);
  return 0;
}

int scenario_show_verb(const ScenarioArguments& arguments) {
  const ResolvedScenario resolved = load(arguments);
  fmt::print("# {} · hash {}\n# key = value [unit] (allowed) · from · what it is · source\n",
             arguments.scenario.string(), resolved.hash);
  const std::vector<KeyEntry> defaults = list_keys(Scenario{});
  const std::vector<KeyEntry> entries = list_keys(resolved.scenario);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const KeyEntry& entry = entries[i];
    const auto origin = resolved.origins.find(entry.key);
    const std::string limits = allowed(entry);
    fmt::print("{} = {}{}{} · {} · {} · {}\n", entry.key, format_value(entry.value),
               entry.unit.empty() ? "" : " [" + entry.unit + "]",
               limits.empty() ? "" : " (" + limits + ")",
               origin == resolved.origins.end()
                   ? "default"
                   : origin->second + ", default " + format_value(defaults[i].value),
               entry.help, entry.source);
  }
  return 0;
}

int scenario_diff_verb(const ScenarioArguments& arguments, const std::filesystem::path& other) {
  const std::vector<KeyEntry> ours = list_keys(load(arguments).scenario);
  const std::vector<KeyEntry> theirs =
      list_keys(other.empty() ? Scenario{} : load_scenario(other).scenario);
  int differing = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i].value == theirs[i].value) continue;
    ++differing;
    fmt::print("{} = {} | {}\n", ours[i].key, format_value(ours[i].value),
               format_value(theirs[i].value));
  }
  fmt::print("{} of {} keys differ: {} | {}\n", differing, ours.size(), arguments.scenario.string(),
             other.empty() ? "defaults" : other.string());
  return 0;
}

}  // namespace honka::eval
