#include "eval/study/sbatch.h"

#include <fmt/format.h>

#include <algorithm>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

constexpr std::int64_t kMostShards = 10000, kMostCores = 1024;
constexpr std::string_view kLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";

/// Slurm sends SIGTERM so long before the end of the time, for trials under way to be let go.
constexpr int kWarning_s = 60;

void check_sbatch_word(const std::string& option, const std::string& text, const char* letters,
                       const char* example) {
  if (text.find_first_not_of(letters) == std::string::npos) return;
  throw UserError(
      fmt::format("{}: '{}' is nothing that sbatch takes; give it as {}", option, text, example));
}

void check_sbatch_options(const SbatchOptions& options) {
  if (options.shards < 1 || options.shards > kMostShards) {
    throw UserError(fmt::format("--shards: {} is not from 1 to {}", options.shards, kMostShards));
  }
  if (options.threads < 1 || options.threads > kMostCores) {
    throw UserError(fmt::format("--threads: {} is not from 1 to {}", options.threads, kMostCores));
  }
  check_sbatch_word("--time", options.time, "0123456789:-", "hours:minutes:seconds");
  check_sbatch_word("--memory", options.memory, "0123456789KMGT", "8G");
  for (const std::string& extra : options.extra) {
    if (extra.starts_with("--") && extra.find('\n') == std::string::npos) continue;
    throw UserError(fmt::format(
        "--extra: '{}' is no option of sbatch; give it with its dashes, as --extra=--account=NAME",
        extra));
  }
}

/// The command of one shard; `shard` and `threads` are put in as they are.
std::string shard_command(const SbatchOptions& options, const std::string& shard,
                          const std::string& threads) {
  std::string command =
      shell_word(options.program.string()) + " study " + shell_word(options.scenario.string());
  for (const std::string& text : options.overrides) command += " -s " + shell_word(text);
  if (options.trials) command += fmt::format(" --trials {}", *options.trials);
  return command + fmt::format(" --shard {} --threads {} --out {}", shard, threads,
                               shell_word(options.folder.string()));
}

std::string study_part(const SbatchOptions& options, const std::string& part) {
  return shell_word(options.program.string()) + " study " + part + " " +
         shell_word(options.folder.string());
}

/// A name for the list of jobs: no blanks, no marks.
std::string job_name(const SbatchOptions& options) {
  std::string name = options.scenario.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return kLetters.find(c) == kLetters.npos; }, '_');
  return "honka-" + name;
}

std::string shared_directives(const SbatchOptions& options) {
  std::string text = "#SBATCH --ntasks=1\n#SBATCH --open-mode=append\n";
  if (!options.time.empty()) text += "#SBATCH --time=" + options.time + "\n";
  for (const std::string& extra : options.extra) text += "#SBATCH " + extra + "\n";
  return text;
}

std::string array_script(const SbatchOptions& options) {
  std::string text = fmt::format(
      "#!/bin/bash\n"
      "# One shard of a study a member. A member that was killed goes on where it stood.\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --array=0-{}\n"
      "#SBATCH --cpus-per-task={}\n"
      "#SBATCH --requeue\n",
      job_name(options), options.shards - 1, options.threads);
  text += shared_directives(options);
  if (!options.memory.empty()) text += "#SBATCH --mem=" + options.memory + "\n";
  if (!options.time.empty()) text += fmt::format("#SBATCH --signal=B:TERM@{}\n", kWarning_s);
  text += "export OMP_WAIT_POLICY=passive\n";
  text += shard_command(options, fmt::format("\"$SLURM_ARRAY_TASK_ID\"/{}", options.shards),
                        "\"$SLURM_CPUS_PER_TASK\"");
  text += R"( &
member=$!
stopped=
trap 'stopped=yes; kill -TERM "$member"' TERM
wait "$member"
code=$?
# A signal ends the first wait, not the member.
if [ -n "$stopped" ]; then
  wait "$member"
  code=$?
fi
# Stopped before the end (3): where slurm.conf says RequeueExit=75, Slurm gives it another turn.
if [ -n "$stopped" ] && [ "$code" -eq 3 ]; then code=75; fi
exit "$code"
)";
  return text;
}

std::string merge_script(const SbatchOptions& options) {
  return fmt::format(
      "#!/bin/bash\n"
      "# Puts the shards of a study together. It runs whatever came of them, and checks itself\n"
      "# that none is missing.\n"
      "#SBATCH --job-name={}-merge\n"
      "{}"
      "{} && exit\n"
      "code=$?\n"
      "{}\n"
      "echo \"To run what is missing, and merge again: sh\" {}\n"
      "exit \"$code\"\n",
      job_name(options), shared_directives(options), study_part(options, "merge"),
      study_part(options, "status"), shell_word((options.folder / "slurm/submit.sh").string()));
}

std::string submit_script(const SbatchOptions& options) {
  const std::string scripts = (options.folder / "slurm").string();
  // sbatch reads % in the name of a log as the beginning of a pattern.
  std::string logs = scripts;
  for (std::size_t at = 0; (at = logs.find('%', at)) != std::string::npos; at += 2) {
    logs.insert(at, "%");
  }
  return fmt::format(
      "#!/bin/sh\n"
      "# Submits a study, or what is missing of it. Options go to sbatch: --array=2,5 runs these\n"
      "# shards alone.\n"
      "set -e\n"
      "cd {}\n"
      "array=$(sbatch --parsable --output={} \"$@\" {})\n"
      "array=${{array%%;*}}\n"
      "merge=$(sbatch --parsable --dependency=\"afterany:$array\" --output={} {})\n"
      "echo \"array job $array, merge job ${{merge%%;*}}; how far it is:\" {}\n",
      shell_word(options.working_folder.string()), shell_word(logs + "/shard_%a.log"),
      shell_word(scripts + "/array.sbatch"), shell_word(logs + "/merge.log"),
      shell_word(scripts + "/merge.sbatch"), shell_word(study_part(options, "status")));
}

}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && text.find_first_not_of(kLetters) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

SbatchScripts sbatch_scripts(const SbatchOptions& options) {
  check_sbatch_options(options);
  return {array_script(options), merge_script(options), submit_script(options)};
}

std::string parallel_commands(const SbatchOptions& options) {
  check_sbatch_options(options);
  // parallel gives its command to a shell: one word for us, quoted as a whole.
  const std::string shard = shard_command(options, fmt::format("{{}}/{}", options.shards),
                                          std::to_string(options.threads));
  return fmt::format("seq 0 {} | parallel -j 1 {}\n{}\n", options.shards - 1, shell_word(shard),
                     study_part(options, "merge"));
}

}  // namespace honka::eval
