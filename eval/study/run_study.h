#pragma once

#include <string>

#include "eval/study/shard.h"
#include "eval/study/study.h"
#include "eval/study/study_folder.h"
#include "eval/study/study_results.h"
#include "eval/study/worker.h"

namespace honka::eval {

/// What came of a shard, with what an earlier call of the same study left.
struct ShardOutcome {
  std::int64_t trials = 0, run_now = 0, failed = 0;
};

/// Runs what is missing of a shard in `threads` worker processes, and writes its file when nothing
/// is. Every trial is on disk as soon as it ends, so that a process which is killed loses those
/// under way and no others. With `retry_failed`, failed trials count as missing. UserError as
/// StudyFolder::enter() and Journal; RunError where the disk is full, to go on from later.
ShardOutcome run_shard(const StudyFolder& folder, const Study& study, const Shard& shard,
                       int threads, bool retry_failed = false);

/// Puts the finished shards of a folder together and writes the results. UserError where shards or
/// trials are missing, overlap, are cut short, or are of another study or version; nothing is
/// overwritten then.
[[nodiscard]] StudyOutcome merge_study(const StudyFolder& folder, const Study& study,
                                       const std::string& command);

/// One trial alone, as its worker would run it. What it throws comes through.
[[nodiscard]] std::vector<MethodResult> run_trial(const Study& study, TrialId id);

/// What a worker keeps from trial to trial: the subject of the point that it is at.
[[nodiscard]] RunTrial make_trial_runner(const Study& study);

}  // namespace honka::eval
