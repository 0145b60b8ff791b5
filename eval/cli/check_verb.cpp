#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "algo/types/user_error.h"
#include "eval/cli/study_verb.h"
#include "eval/cli/verbs.h"
#include "eval/config/scenario.h"
#include "eval/io/build_info.h"
#include "eval/io/text_table.h"
#include "eval/run/check/compare.h"
#include "eval/run/check/reference.h"
#include "eval/run/check/track_figures.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

const fs::path kReferences = "results/reference";
constexpr int kOutside = 1, kNotCompared = 2;

/// A name as it stands below results/reference, from whatever of its files was given.
std::string bare_name(const std::string& given) {
  std::string name = fs::path(given).lexically_normal().generic_string();
  for (const std::string begin : {"results/reference/", "results/", "scenarios/"}) {
    if (name.starts_with(begin)) name.erase(0, begin.size());
  }
  for (const std::string end : {".csv", ".toml", "/"}) {
    if (name.ends_with(end)) name.erase(name.size() - end.size());
  }
  return name;
}

std::string meant(const std::string& name, const std::vector<std::string>& names) {
  const auto near = did_you_mean(name, names);
  return near ? fmt::format("; did you mean {}?", *near) : "";
}

/// The references that were asked for: by name, by folder, or all.
std::vector<std::string> chosen_references(const std::vector<std::string>& asked) {
  const auto all = reference_names(kReferences);
  if (all.empty()) {
    throw UserError(
        "results/reference: no references here; go to the folder that holds results/, "
        "or make one: honka check --accept NAME --why TEXT");
  }
  if (asked.empty()) return all;
  std::vector<std::string> chosen;
  for (const std::string& given : asked) {
    const std::string name = bare_name(given);
    const std::size_t before = chosen.size();
    for (const std::string& known : all) {
      if (known == name || known.starts_with(name + "/")) chosen.push_back(known);
    }
    if (chosen.size() > before) continue;
    throw UserError(
        fmt::format("{}: no such reference under results/reference{}", given, meant(name, all)));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

fs::path results_of(const std::string& name) { return fs::path("results") / name; }

std::string command_for(const std::string& scenario, const ResolvedScenario& resolved) {
  const bool is_study = resolved.scenario.study.asked_for();
  return fmt::format("honka {} {}", is_study ? "study" : "run", scenario);
}

bool is_true(const Summary& summary, const std::string& key) {
  const auto it = summary.context.find(key);
  return it != summary.context.end() && it->second == "true";
}

std::string context_text(const Summary& summary, const std::string& key) {
  const auto it = summary.context.find(key);
  return it == summary.context.end() ? "unknown" : it->second;
}

/// Whether only some of the trials are in the results: their command tells.
bool is_of_other_trials(const Summary& summary, const Scenario& scenario) {
  const std::string command = summary.report.reproduce + " ";
  if (!scenario.study.asked_for()) return command.find(" --trial ") != std::string::npos;
  return command.find(fmt::format(" --trials {} ", scenario.study.trials)) == std::string::npos;
}

/// Why a folder does not hold the results of a scenario; empty when it does.
std::string why_not(const fs::path& folder, const ResolvedScenario& resolved) {
  if (!fs::exists(folder / "summary.json")) return "no summary.json";
  const Summary summary = read_summary(folder / "summary.json");
  if (summary.scenario_hash != resolved.hash) {
    return "made from another scenario or with keys on top";
  }
  return is_of_other_trials(summary, resolved.scenario) ? "not of all the scenario's trials" : "";
}

/// Results of another build of honka than this one, or of an unknown state of it.
bool is_of_other_build(const Summary& summary) {
  const BuildInfo build = build_info();
  return build.dirty || is_true(summary, "dirty") ||
         context_text(summary, "commit") != build.commit;
}

/// Makes the results where they are missing, of another scenario or of another build.
void run_where_needed(const ResolvedScenario& resolved, const fs::path& folder, int threads) {
  if (why_not(folder, resolved).empty() &&
      !is_of_other_build(read_summary(folder / "summary.json"))) {
    return;
  }
  if (resolved.scenario.study.asked_for()) {
    StudyArguments arguments;
    arguments.scenario = resolved.file;
    arguments.threads = threads;
    arguments.out = folder;
    study_verb(arguments);
  } else {
    RunArguments arguments;
    arguments.scenario = resolved.file;
    arguments.threads = threads;
    arguments.out = folder;
    run_verb(arguments);
  }
}

/// Sees to it that a reference has results to compare with; UserError that says how to come to
/// them.
void see_to_results(const Reference& reference, const std::string& name,
                    const CheckArguments& arguments) {
  const ResolvedScenario resolved = load_scenario(reference.scenario);
  if (resolved.hash != reference.scenario_hash) {
    throw UserError(fmt::format(
        "{}: the scenario has changed since its reference was accepted; {}, then honka check "
        "--accept {} --why TEXT",
        reference.scenario, command_for(reference.scenario, resolved), name));
  }
  if (arguments.run) run_where_needed(resolved, results_of(name), arguments.threads);
  const std::string why = why_not(results_of(name), resolved);
  if (why.empty()) return;
  throw UserError(fmt::format("{}: {}; make them: {}", results_of(name).string(), why,
                              command_for(reference.scenario, resolved)));
}

std::string verdict_of(const FigureComparison& comparison, bool same_digits) {
  if (!comparison.outside.empty()) {
    return fmt::format("{} of {} figures outside their tolerance", comparison.outside.size(),
                       comparison.figures);
  }
  return fmt::format("{}, {} figures",
                     same_digits ? "same digits" : "other digits, within tolerance",
                     comparison.figures);
}

/// Compares one scenario's results with its reference and says what came out.
bool check_one(const std::string& name, const Reference& reference) {
  const fs::path folder = results_of(name);
  const Summary summary = read_summary(folder / "summary.json");
  auto now = figures_of(summary);
  for (CheckFigure& figure : track_figures(reference.figures, folder, kReferences)) {
    now.push_back(std::move(figure));
  }
  const FigureComparison comparison = compare_figures(reference.figures, now);
  const bool same = summary.results_digest == reference.results_digest;
  fmt::print("{}: {}\n", name, verdict_of(comparison, same));
  if (comparison.added > 0) {
    fmt::print("  {} figures are new: the reference does not hold them\n", comparison.added);
  }
  if (is_of_other_build(summary)) {
    fmt::print(
        "  the results are of commit {}{}, not surely of this build; --run makes them anew\n",
        context_text(summary, "commit").substr(0, 8), is_true(summary, "dirty") ? ", changed" : "");
  }
  if (comparison.outside.empty()) return true;
  fmt::print("{}", differences_text(comparison.outside));
  fmt::print("  reference of {} ({}): {}\n", reference.date, reference.commit.substr(0, 8),
             reference.reason);
  return false;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  if (!fs::is_directory("scenarios")) return names;
  for (const auto& entry : fs::recursive_directory_iterator("scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    names.push_back(bare_name(entry.path().generic_string()));
  }
  return names;
}

/// The results that are to become a reference; UserError for those that nobody could repeat.
Summary acceptable_results(const std::string& name, const std::string& scenario) {
  const ResolvedScenario resolved = load_scenario(scenario);
  const fs::path folder = results_of(name);
  const std::string command = command_for(scenario, resolved);
  if (const std::string why = why_not(folder, resolved); !why.empty()) {
    throw UserError(fmt::format("{}: {}; make them: {}", folder.string(), why, command));
  }
  Summary summary = read_summary(folder / "summary.json");
  if (is_true(summary, "dirty") || context_text(summary, "commit") == "unknown") {
    throw UserError(
        fmt::format("{}: made by a honka with changes that are not committed; commit, "
                    "build, then {}",
                    folder.string(), command));
  }
  return summary;
}

int accept(const CheckArguments& arguments) {
  const std::string name = bare_name(*arguments.accept);
  const std::string scenario = "scenarios/" + name + ".toml";
  if (arguments.why.find_first_not_of(" \t\n") == std::string::npos) {
    throw UserError("--accept " + name + ": say why the figures changed: --why TEXT");
  }
  if (!fs::exists(scenario)) {
    throw UserError(scenario + ": no such scenario" + meant(name, scenario_names()));
  }
  const Summary summary = acceptable_results(name, scenario);
  Reference reference{scenario,
                      summary.scenario_hash,
                      summary.results_digest,
                      context_text(summary, "commit"),
                      context_text(summary, "compiler"),
                      utc_now(),
                      arguments.why,
                      figures_of(summary)};
  for (CheckFigure& figure : accept_tracks(results_of(name), kReferences, name)) {
    reference.figures.push_back(std::move(figure));
  }
  const fs::path file = kReferences / (name + ".csv");
  write_reference(file, reference);
  fmt::print("{}: {} figures of commit {}\n", file.string(), reference.figures.size(),
             reference.commit.substr(0, 8));
  return 0;
}

}  // namespace

int check_verb(const CheckArguments& arguments) {
  if (arguments.accept) return accept(arguments);
  if (!arguments.why.empty()) throw UserError("--why goes with --accept NAME");
  bool all_within = true;
  std::vector<std::string> not_compared;
  for (const std::string& name : chosen_references(arguments.names)) {
    const Reference reference = read_reference(kReferences / (name + ".csv"));
    try {
      see_to_results(reference, name, arguments);
    } catch (const UserError& error) {
      not_compared.push_back(error.what());
      continue;
    }
    all_within = check_one(name, reference) && all_within;
  }
  for (const std::string& why : not_compared) std::fprintf(stderr, "honka: %s\n", why.c_str());
  if (!all_within) return kOutside;
  return not_compared.empty() ? 0 : kNotCompared;
}

}  // namespace honka::eval
