#include "eval/cli/study_verb.h"

namespace honka::eval {
namespace {

constexpr int kMostThreads = 1024;
constexpr std::int64_t kMostTrials = 10000000;

void add_study_run(CLI::App& verb, StudyArguments& arguments) {
  verb.add_option("SCENARIO", arguments.scenario, "scenario file with [study.vary] (TOML)");
  verb.add_option("-s,--set", arguments.overrides, "key=value on top of the file, repeatable")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_option("--seed", arguments.seed, "in place of the scenario's seed");
  verb.add_option("--trials", arguments.trials, "at each point")
      ->check(CLI::Range(std::int64_t{1}, kMostTrials));
  verb.add_option("--shard", arguments.shard, "i/N: part i of N, from 0");
  verb.add_option("--threads", arguments.threads, "trials at a time; 0: one a core")
      ->check(CLI::Range(0, kMostThreads));
  verb.add_option("--out", arguments.out, "folder of the study");
}

}  // namespace

void add_study(CLI::App& app, StudyVerbArguments& arguments, std::function<int()>& action) {
  auto& verb = *app.add_subcommand("study", "many trials at many points, to go on from any time");
  verb.require_subcommand(0, 1);
  add_study_run(verb, arguments.run);
  verb.callback([&] {
    if (verb.get_subcommands().empty()) action = [&] { return study_verb(arguments.run); };
  });
  const auto add = [&](const char* name, const char* help, std::function<int()> act) {
    auto& part = *verb.add_subcommand(name, help);
    part.add_option("DIR", arguments.folder, "folder of the study")->required();
    part.callback([&action, act = std::move(act)] { action = act; });
    return &part;
  };
  add("status", "how far each shard is, and what to do next",
      [&] { return study_status_verb(arguments.folder); });
  add("merge", "finished shards into tables, figures and report",
      [&] { return study_merge_verb(arguments.folder); });
  auto* retry = add("retry-failed", "run the failed trials again",
                    [&] { return study_retry_verb(arguments.folder, arguments.retry_threads); });
  add_study_sbatch(verb, arguments.sbatch, action);
  retry->add_option("--threads", arguments.retry_threads, "trials at a time; 0: one a core")
      ->check(CLI::Range(0, kMostThreads));
}

}  // namespace honka::eval
