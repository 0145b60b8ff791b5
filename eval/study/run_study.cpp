#include "eval/study/run_study.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "eval/io/interruption.h"
#include "eval/study/journal.h"
#include "eval/study/point_ends.h"
#include "eval/study/study_progress.h"
#include "eval/study/worker_pool.h"

namespace honka::eval {
namespace {

using KnownTrials = std::map<TrialId, TrialRecord>;

bool failed(const TrialRecord& record) { return record.status != TrialStatus::kDone; }

/// The trials of a finished shard's file, which are few where more trials have been asked for.
KnownTrials finished_trials(const StudyFolder& folder, const Study& study, const Shard& shard,
                            bool retry_failed) {
  KnownTrials known;
  if (!std::filesystem::exists(folder.finished(shard))) return known;
  for (TrialRecord& record : records_of(study, read_shard(folder, study, shard))) {
    if (!(retry_failed && failed(record))) known[record.id] = std::move(record);
  }
  return known;
}

std::vector<TrialBatch> without(std::vector<TrialBatch> batches, const KnownTrials& known) {
  for (TrialBatch& batch : batches) {
    std::erase_if(batch, [&](TrialId id) { return known.contains(id); });
  }
  std::erase_if(batches, [](const TrialBatch& batch) { return batch.empty(); });
  return batches;
}

std::int64_t count_of(const std::vector<TrialBatch>& batches) {
  std::size_t count = 0;
  for (const TrialBatch& batch : batches) count += batch.size();
  return static_cast<std::int64_t>(count);
}

void finish(const StudyFolder& folder, const Study& study, const Shard& shard, KnownTrials known,
            Journal& journal) {
  std::vector<TrialRecord> records;
  for (auto& [id, record] : known) records.push_back(std::move(record));
  write_shard(folder, study, shard, std::move(records));
  journal.remove();
}

std::string title_of(const Shard& shard) {
  return shard.count == 1 ? "study" : fmt::format("study, shard {}/{}", shard.index, shard.count);
}

/// Runs the batches; each trial goes to disk, then to `known`.
void run_missing(const Study& study, const Shard& shard, std::vector<TrialBatch> missing,
                 int threads, KnownTrials& known, Journal& journal) {
  StudyProgress progress(study, title_of(shard), count_of(missing));
  PointEnds ends(study);
  for (const auto& [id, record] : known) {
    progress.count(record);
    ends.add(record);
  }
  PoolOrder order;
  order.workers = static_cast<int>(std::clamp<std::int64_t>(count_of(missing), 1, threads));
  order.limits = {study.base.scenario.study.time_limit_s,
                  study.base.scenario.study.memory_limit_mb};
  order.make = [&] { return make_trial_runner(study); };
  // A shard of several sees too few trials of a point to know when to stop; the merge does.
  order.wanted = [&](TrialId id) {
    const bool wanted = shard.count > 1 || id.trial < ends.end(id.point);
    if (!wanted) progress.skip();
    return wanted;
  };
  order.take = [&](TrialRecord record) {
    journal.append(record);
    progress.advance(record);
    ends.add(record);
    known[record.id] = std::move(record);
  };
  run_in_workers(std::move(missing), order);
}

}  // namespace

RunTrial make_trial_runner(const Study& study) {
  omp_set_num_threads(1);  // the workers are what runs side by side
  auto subject = std::make_shared<std::unique_ptr<StudySubject>>();
  auto at = std::make_shared<std::optional<std::int64_t>>();
  return [&study, subject, at](TrialId id) {
    if (*at != id.point) {
      at->reset();
      subject->reset();  // before the next one takes memory
      *subject =
          study.kind->make(study.points.at(static_cast<std::size_t>(id.point)).resolved.scenario);
      *at = id.point;
    }
    return (*subject)->run(id.trial);
  };
}

std::vector<MethodResult> run_trial(const Study& study, TrialId id) {
  return make_trial_runner(study)(id);
}

ShardOutcome run_shard(const StudyFolder& folder, const Study& study, const Shard& shard,
                       int threads, bool retry_failed) {
  // What is known already
  folder.enter(study, shard);
  when_interrupted_say("every finished trial is kept; give the same command to go on from there");
  KnownTrials known = finished_trials(folder, study, shard, retry_failed);
  Journal journal(folder.journal(shard), journal_title(study, shard), [&](TrialRecord record) {
    if (retry_failed && failed(record)) {
      known.erase(record.id);
    } else {
      known[record.id] = std::move(record);
    }
  });

  // What is missing
  auto missing = without(batches_of(study, shard), known);
  const auto before = static_cast<std::int64_t>(known.size());
  if (!missing.empty()) run_missing(study, shard, std::move(missing), threads, known, journal);

  // The shard's file
  ShardOutcome outcome;
  outcome.trials = static_cast<std::int64_t>(known.size());
  outcome.run_now = outcome.trials - before;
  outcome.failed = std::count_if(known.begin(), known.end(),
                                 [](const auto& entry) { return failed(entry.second); });
  finish(folder, study, shard, std::move(known), journal);
  return outcome;
}

}  // namespace honka::eval
