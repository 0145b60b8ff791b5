#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace honka::eval {

/// What a study is given of a cluster.
struct SbatchOptions {
  std::filesystem::path program, scenario, folder;  ///< absolute: honka, the study, its folder
  std::filesystem::path working_folder;             ///< absolute: paths within the scenario
  std::vector<std::string> overrides;               ///< "key=value"
  std::optional<std::int64_t> trials;               ///< at each point
  std::int64_t shards = 1;                          ///< members of the array
  std::int64_t threads = 8;                         ///< trials at a time in each: its cores
  std::string time;                                 ///< limit as Slurm has it; empty: the site's
  std::string memory;                               ///< of a member; empty: the site's
  std::vector<std::string> extra;                   ///< more options of sbatch, "--partition=long"
};

/// Job scripts for Slurm.
struct SbatchScripts {
  std::string array;   ///< one shard a member; each goes on where it stood, however it ended
  std::string merge;   ///< puts the shards together, or says what is missing
  std::string submit;  ///< submits both, the second after the first, whatever came of it
};

/// The scripts, to be written as slurm/array.sbatch, merge.sbatch and submit.sh in the study's
/// folder. A member that Slurm stops with SIGTERM before its end exits with 75, which sites with
/// RequeueExit=75 answer by another turn. UserError at options that no job script can hold.
[[nodiscard]] SbatchScripts sbatch_scripts(const SbatchOptions& options);

/// The same work by GNU parallel, as lines of a shell.
[[nodiscard]] std::string parallel_commands(const SbatchOptions& options);

/// A word as a shell takes it: quoted where it holds anything but plain letters.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace honka::eval
