#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>

#include "algo/localize/matcher.h"
#include "algo/slam/registration/register.h"
#include "algo/types/user_error.h"
#include "eval/cli/study_verb.h"
#include "eval/cli/verbs.h"
#include "eval/io/interruption.h"

namespace honka::eval {
namespace {

constexpr int kUserMistake = 2;
constexpr int kUnfinished = 3;

constexpr int kMostThreads = 1024;
constexpr double kLargestTolerance_m2 = 1000.0;

/// What the parsed command line asks for; empty until a verb was seen.
using Action = std::function<int()>;

void add_scenario_options(CLI::App& verb, ScenarioArguments& arguments) {
  verb.add_option("SCENARIO", arguments.scenario, "scenario file (TOML)")->required();
  verb.add_option("-s,--set", arguments.overrides, "key=value on top of the file, repeatable")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_option("--seed", arguments.seed, "in place of the scenario's seed");
}

void add_run(CLI::App& app, RunArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("run", "run a scenario: tables, figures, report");
  add_scenario_options(verb, arguments);
  verb.add_option("--threads", arguments.threads, "0: as many as there are cores")
      ->check(CLI::Range(0, kMostThreads));
  verb.add_option("--trial", arguments.trial, "one trial (stand) alone")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1000000}));
  verb.add_option("--out", arguments.out, "folder of the results");
  verb.callback([&] { action = [&] { return run_verb(arguments); }; });
}

void add_simulate(CLI::App& app, SimulateArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("simulate", "record a drive through a stand: scans and truth");
  add_scenario_options(verb, arguments);
  verb.add_option("--threads", arguments.threads, "0: as many as there are cores")
      ->check(CLI::Range(0, kMostThreads));
  verb.add_option("--out", arguments.out, "recording to write (.h5)")->required();
  verb.callback([&] { action = [&] { return simulate_verb(arguments); }; });
}

void add_locate(CLI::App& app, LocateArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("locate", "find stem lists in a stem map");
  verb.add_option("MAP", arguments.map, "stem list of the map (CSV)")->required();
  verb.add_option("LOCAL", arguments.locals, "stem lists seen from the sensor (CSV)")->required();
  verb.add_option("--method", arguments.method, "how: li2020 or consensus");
  verb.add_option("--tolerance-m2", arguments.tolerance_m2, "of a triangle and its neighbours")
      ->check(CLI::Range(0.0, kLargestTolerance_m2));
  verb.add_option("--stars", arguments.stars, "of li2020: plane, or space (heights, any tilt)")
      ->check(CLI::IsMember({"plane", "space"}));
  verb.add_option("--prior", arguments.prior, "x,y,radius: the sensor is within (m)");
  verb.add_option("--index", arguments.index, "of consensus: loaded if it is of MAP, else written");
  verb.add_flag("--json", arguments.json, "one JSON object a local file");
  verb.callback([&] { action = [&] { return locate_verb(arguments); }; });
}

void add_update_map(CLI::App& app, UpdateMapArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("update-map", "bring a stem map up to date by stem lists");
  verb.add_option("MAP", arguments.map, "stem list of the map (CSV)")->required();
  verb.add_option("LOCAL", arguments.locals, "stem lists seen from the sensor (CSV), in order")
      ->required();
  verb.add_option("--out", arguments.out, "stem list of the updated map (CSV)")->required();
  verb.add_option("--method", arguments.method, "how lists are found: consensus or li2020")
      ->check(CLI::IsMember(matcher_names()));
  verb.add_option("--tolerance-m2", arguments.tolerance_m2, "of li2020, as in locate")
      ->check(CLI::Range(0.0, kLargestTolerance_m2));
  verb.add_option("--range-m", arguments.range_m, "up to which the lists are to be trusted")
      ->check(CLI::Range(1.0, 1000.0));
  verb.add_option("--view-deg", arguments.field_of_view_deg, "of the sensor, about its x axis")
      ->check(CLI::Range(1.0, 360.0));
  verb.add_option("--every", arguments.every, "lists from one update of the map to the next")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000}));
  verb.add_flag("--json", arguments.json, "one JSON object");
  verb.callback([&] { action = [&] { return update_map_verb(arguments); }; });
}

void add_register(CLI::App& app, RegisterArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("register", "lay one sparse cloud onto another");
  verb.add_option("TARGET", arguments.target, "cloud that stays (CSV)")->required();
  verb.add_option("SOURCE", arguments.source, "cloud that is moved (CSV)")->required();
  verb.add_option("--method", arguments.method, "icp, go_icp or landmarks")
      ->required()
      ->check(CLI::IsMember(registration_methods()));
  verb.add_option("--mode", arguments.mode, "of go_icp: certify or l0")
      ->check(CLI::IsMember({"certify", "l0"}));
  verb.add_option("--inlier-share", arguments.inlier_share, "part of SOURCE that has partners");
  verb.add_flag("--json", arguments.json, "one JSON object");
  verb.callback([&] { action = [&] { return register_verb(arguments); }; });
}

void add_slam(CLI::App& app, SlamArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("slam", "lay key frames of stems into one map");
  verb.add_option("FRAMES", arguments.frames, "stems a key frame (CSV, also gzipped)")->required();
  verb.add_option("--chain", arguments.chain, "poses of the frames, 12 numbers a row");
  verb.add_option("--method", arguments.method, "how: see honka help slam");
  verb.add_flag("--propose", arguments.propose, "look for pairs that the poses do not show, too");
  verb.add_option("--vehicle", arguments.vehicles, "frames of another vehicle there, repeatable")
      ->expected(1);
  verb.add_option("--out", arguments.out, "folder of the results")->required();
  verb.callback([&] { action = [&] { return slam_verb(arguments); }; });
}

void add_score(CLI::App& app, ScoreArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("score", "judge a result made elsewhere against a recording");
  verb.add_option("RECORDING", arguments.recording, "recording with truth (.h5)")->required();
  verb.add_option("POSES", arguments.poses, "T_world_lidar as TUM rows")->required();
  verb.add_option("STEMS", arguments.stems, "stem list in the world frame (CSV)");
  verb.callback([&] { action = [&] { return score_verb(arguments); }; });
}

void add_evaluate(CLI::App& app, EvaluateArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("evaluate", "errors of a trajectory: APE and RPE");
  verb.add_option("TRUTH", arguments.truth, "true trajectory")->required();
  verb.add_option("ESTIMATE", arguments.estimate, "estimated trajectory")->required();
  verb.add_option("--format", arguments.format, "tum or kitti")
      ->check(CLI::IsMember({"tum", "kitti"}));
  verb.add_option("--align", arguments.align, "none, origin, yaw, se2, se3 or sim3");
  verb.add_option("--max-time-difference", arguments.max_time_difference_s,
                  "seconds between poses that belong together");
  verb.add_option("--delta", arguments.delta, "of a motion: 1s, 10m, 1f (frames)");
  verb.add_flag("--all-pairs", arguments.all_pairs, "metres, frames: motions from every pose");
  verb.add_flag("--json", arguments.json, "one JSON object");
  verb.add_option("--plot", arguments.plot, "folder for figures of the trajectories and errors");
  verb.callback([&] { action = [&] { return evaluate_verb(arguments); }; });
}

void add_check(CLI::App& app, CheckArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("check", "hold results against their references");
  verb.add_option("NAME", arguments.names, "scenarios or folders of them; left out: all");
  verb.add_flag("--run", arguments.run, "first make results that are missing or of another build");
  verb.add_option("--threads", arguments.threads, "of --run; 0: as many as there are cores")
      ->check(CLI::Range(0, kMostThreads));
  verb.add_option("--accept", arguments.accept, "scenario whose results become its reference");
  verb.add_option("--why", arguments.why, "of --accept: what changed the figures");
  verb.callback([&] { action = [&] { return check_verb(arguments); }; });
}

struct ScenarioVerbArguments {
  ScenarioArguments check, show, diff;
  std::filesystem::path other;
};

void add_scenario(CLI::App& app, ScenarioVerbArguments& arguments, Action& action) {
  auto& verb = *app.add_subcommand("scenario", "check, show or compare scenario files");
  verb.require_subcommand(1);
  auto& check = *verb.add_subcommand("check", "read the file and say what is wrong with it");
  add_scenario_options(check, arguments.check);
  check.callback([&] { action = [&] { return scenario_check_verb(arguments.check); }; });
  auto& show = *verb.add_subcommand("show", "every key with value, unit, origin and source");
  add_scenario_options(show, arguments.show);
  show.callback([&] { action = [&] { return scenario_show_verb(arguments.show); }; });
  auto& diff = *verb.add_subcommand("diff", "the keys in which two scenarios differ");
  add_scenario_options(diff, arguments.diff);
  diff.add_option("OTHER", arguments.other, "the other file; left out: the defaults");
  diff.callback(
      [&] { action = [&] { return scenario_diff_verb(arguments.diff, arguments.other); }; });
}

int parse_and_act(int argc, char** argv) {
  CLI::App app("honka: lidar localization and SLAM in forests, simulated and judged against truth");
  app.set_version_flag("--version", "honka " HONKA_VERSION);
  app.require_subcommand(0, 1);
  RunArguments run;
  SimulateArguments simulate;
  LocateArguments locate;
  UpdateMapArguments update_map;
  SlamArguments slam;
  ScoreArguments score;
  RegisterArguments registration;
  EvaluateArguments evaluate;
  CheckArguments check;
  ScenarioVerbArguments scenario;
  StudyVerbArguments study;
  std::filesystem::path report_folder;
  std::string topic;
  Action action = [&] { return help_verb(""); };
  add_run(app, run, action);
  add_study(app, study, action);
  add_simulate(app, simulate, action);
  add_locate(app, locate, action);
  add_update_map(app, update_map, action);
  add_register(app, registration, action);
  add_slam(app, slam, action);
  add_score(app, score, action);
  add_evaluate(app, evaluate, action);
  add_check(app, check, action);
  add_scenario(app, scenario, action);
  auto& report = *app.add_subcommand("report", "write report.html of a results folder anew");
  report.add_option("DIR", report_folder, "folder of the results")->required();
  report.callback([&] { action = [&] { return report_verb(report_folder); }; });
  auto& help = *app.add_subcommand("help", "what honka does and how");
  help.add_option("TOPIC", topic, "a verb, or: scenarios, experiments, formats, keys");
  help.callback([&] { action = [&] { return help_verb(topic); }; });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw UserError(std::string(error.what()) + "; see honka help");
  }
  return action();
}

}  // namespace
}  // namespace honka::eval

int main(int argc, char** argv) {
  honka::eval::end_cleanly_when_interrupted();
  try {
    return honka::eval::parse_and_act(argc, argv);
  } catch (const honka::UserError& error) {
    std::fprintf(stderr, "honka: %s\n", error.what());
    return honka::eval::kUserMistake;
  } catch (const honka::RunError& error) {
    std::fprintf(stderr, "honka: %s\n", error.what());
    return honka::eval::kUnfinished;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "honka: %s; please report this with the command that led to it\n",
                 error.what());
    return honka::eval::kUnfinished;
  }
}
