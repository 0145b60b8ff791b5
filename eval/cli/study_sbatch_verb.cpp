#include "eval/cli/study_sbatch_verb.h"

#include <fmt/format.h>

#include "eval/io/safe_file.h"
#include "eval/study/sbatch.h"
#include "eval/study/study.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

SbatchOptions sbatch_options(const SbatchArguments& arguments, const Study& study) {
  SbatchOptions options;
  std::error_code unknown;
  options.program = fs::read_symlink("/proc/self/exe", unknown);
  if (unknown) options.program = "honka";
  options.scenario = fs::absolute(arguments.scenario).lexically_normal();
  const fs::path out =
      arguments.out.empty() ? "results" / fs::path(study.base.name) : arguments.out;
  options.folder = fs::absolute(out).lexically_normal();
  options.working_folder = fs::current_path();
  options.overrides = arguments.all_overrides();
  options.trials = arguments.trials;
  options.shards = arguments.shards;
  options.threads = arguments.threads;
  options.time = arguments.time;
  options.memory = arguments.memory;
  options.extra = arguments.extra;
  if (!arguments.partition.empty()) {
    options.extra.insert(options.extra.begin(), "--partition=" + arguments.partition);
  }
  return options;
}

}  // namespace

int study_sbatch_verb(const SbatchArguments& arguments) {
  const Study study = load_study(arguments.scenario, arguments.all_overrides(), arguments.trials);
  const SbatchOptions options = sbatch_options(arguments, study);
  const SbatchScripts scripts = sbatch_scripts(options);
  const std::string parallel = parallel_commands(options);
  const fs::path folder = options.folder / "slurm";
  write_file_safely(folder / "array.sbatch", scripts.array);
  write_file_safely(folder / "merge.sbatch", scripts.merge);
  write_file_safely(folder / "submit.sh", scripts.submit);
  fmt::print(
      "{} trials at each of {} points in {} shards of {} cores; scripts in {}\n\n"
      "Submit, also to go on with what is missing:\n  sh {}\n\n"
      "Without Slurm, here with GNU parallel:\n",
      study.trials, study.points.size(), options.shards, options.threads, folder.string(),
      shell_word((folder / "submit.sh").string()));
  for (std::size_t begin = 0; begin < parallel.size();) {
    const std::size_t end = parallel.find('\n', begin);
    fmt::print("  {}\n", parallel.substr(begin, end - begin));
    begin = end + 1;
  }
  return 0;
}

void add_study_sbatch(CLI::App& study, SbatchArguments& arguments, std::function<int()>& action) {
  auto& verb = *study.add_subcommand("sbatch", "job scripts for a Slurm cluster");
  verb.add_option("SCENARIO", arguments.scenario, "scenario file with [study.vary] (TOML)")
      ->required();
  verb.add_option("--shards", arguments.shards, "members of the job array")->required();
  verb.add_option("--threads", arguments.threads, "cores of each member");
  verb.add_option("-s,--set", arguments.overrides, "key=value on top of the file, repeatable")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_option("--seed", arguments.seed, "in place of the scenario's seed");
  verb.add_option("--trials", arguments.trials, "at each point")->check(CLI::PositiveNumber);
  verb.add_option("--time", arguments.time, "limit of a job: hours:minutes:seconds");
  verb.add_option("--memory", arguments.memory, "of a member: 8G");
  verb.add_option("--partition", arguments.partition, "of the cluster");
  verb.add_option("--extra", arguments.extra, "another option of sbatch, repeatable")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb.add_option("--out", arguments.out, "folder of the study");
  verb.callback([&] { action = [&] { return study_sbatch_verb(arguments); }; });
}

}  // namespace honka::eval
