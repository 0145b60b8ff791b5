#include "eval/cli/study_verb.h"

#include <fmt/format.h>

#include "algo/types/user_error.h"
#include "eval/run/thread_count.h"
#include "eval/study/run_study.h"
#include "eval/study/study_status.h"

namespace honka::eval {
namespace {

int merge_and_tell(const StudyFolder& folder, const Study& study) {
  const StudyOutcome outcome = merge_study(folder, study, study_command(study));
  fmt::print("{}\nresults_digest {}\nReport: {}\n", outcome.table, outcome.digest,
             (folder.path() / "report.html").string());
  return 0;
}

void tell_failures(const StudyFolder& folder, const ShardOutcome& outcome) {
  if (outcome.failed == 0) return;
  fmt::print(
      "{} of {} trials failed; they count as failures in every figure, with their causes in the "
      "report. To run them again: honka study retry-failed {}\n",
      outcome.failed, outcome.trials, folder.path().string());
}

}  // namespace

int study_verb(const StudyArguments& arguments) {
  if (arguments.scenario.empty()) {
    throw UserError("study: no scenario given; `ls scenarios/robustness` shows those that ship");
  }
  const Study study = load_study(arguments.scenario, arguments.all_overrides(), arguments.trials);
  const Shard shard = parse_shard(arguments.shard);
  const StudyFolder folder(
      arguments.out.empty() ? "results" / std::filesystem::path(study.base.name) : arguments.out);
  const ShardOutcome outcome = run_shard(folder, study, shard, thread_count(arguments.threads));
  tell_failures(folder, outcome);
  if (shard.count == 1) return merge_and_tell(folder, study);
  fmt::print(
      "shard {}/{}: {} trials, {} of them now\nWhen all {} are there: honka study merge {}\n",
      shard.index, shard.count, outcome.trials, outcome.run_now, shard.count,
      folder.path().string());
  return 0;
}

int study_status_verb(const std::filesystem::path& folder) {
  fmt::print("{}", study_status(StudyFolder(folder)));
  return 0;
}

int study_merge_verb(const std::filesystem::path& folder) {
  const StudyFolder there(folder);
  return merge_and_tell(there, there.study());
}

int study_retry_verb(const std::filesystem::path& folder, int threads) {
  const StudyFolder there(folder);
  const Study study = there.study();
  const auto shards = there.shards();
  if (shards.empty()) {
    throw UserError(folder.string() + ": holds no shards yet; nothing has failed");
  }
  for (const Shard& shard : shards) {
    const ShardOutcome outcome = run_shard(there, study, shard, thread_count(threads), true);
    fmt::print("shard {}/{}: {} trials run again, {} failed\n", shard.index, shard.count,
               outcome.run_now, outcome.failed);
  }
  return merge_and_tell(there, study);
}

int study_trial_verb(const RunArguments& arguments) {
  const Study study = load_study(arguments.scenario, arguments.all_overrides());
  const std::string file = arguments.scenario.string();
  if (!arguments.trial || study.points.size() != 1) {
    std::string point;
    for (const StudyAxis& axis : study.axes()) point += fmt::format(" -s {}=VALUE", axis.key);
    throw UserError(fmt::format(
        "{}: is a study; run it with honka study {}, or one of its trials with honka run {}{} "
        "--trial N",
        file, file, file, point));
  }
  const TrialId id{0, *arguments.trial};
  const auto results = run_trial(study, id);
  fmt::print("trial {} of {}\n", id.trial, file);
  for (const MethodResult& result : results) {
    fmt::print("\n{}\n", result.method);
    for (std::size_t k = 0; k < result.values.size(); ++k) {
      const Measure& measure = study.kind->measures[k];
      fmt::print("  {:<24} {} {}\n", measure.name, result.values[k], measure.unit);
    }
  }
  return 0;
}

}  // namespace honka::eval
