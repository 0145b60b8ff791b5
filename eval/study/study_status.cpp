#include "eval/study/study_status.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "eval/study/journal.h"

namespace honka::eval {
namespace {

struct ShardStatus {
  std::int64_t trials = 0, known = 0;
  std::map<std::string, std::int64_t> failures;  ///< by "status: cause"
  bool begun = false, running = false;

  [[nodiscard]] bool finished() const { return known >= trials; }
};

ShardStatus status_of(const StudyFolder& folder, const Study& study, const Shard& shard) {
  ShardStatus status;
  for (const TrialBatch& batch : batches_of(study, shard)) {
    status.trials += static_cast<std::int64_t>(batch.size());
  }
  std::map<TrialId, TrialRecord> known;
  if (std::filesystem::exists(folder.finished(shard))) {
    status.begun = true;
    for (TrialRecord& record : records_of(study, read_shard(folder, study, shard))) {
      known[record.id] = std::move(record);
    }
  }
  const auto journal = folder.journal(shard);
  if (std::filesystem::exists(journal)) {
    status.begun = true;
    status.running = is_locked(journal);
    for (TrialRecord& record : peek_journal(journal)) known[record.id] = std::move(record);
  }
  status.known = static_cast<std::int64_t>(known.size());
  for (const auto& [id, record] : known) {
    if (record.status == TrialStatus::kDone) continue;
    ++status.failures[fmt::format("{}: {}", name_of(record.status), record.cause)];
  }
  return status;
}

std::string state_of(const ShardStatus& status, bool closed) {
  if (!status.begun) return "not begun";
  if (closed) return "finished";
  return status.running ? "running" : "stopped";
}

std::string next_step(const StudyFolder& folder, const Study& study, const Shard* missing,
                      bool running) {
  const std::string path = folder.path().string();
  if (missing == nullptr) return fmt::format("Next: honka study merge {}\n", path);
  if (running) return fmt::format("Wait for those that run, then: honka study status {}\n", path);
  return fmt::format("Next: {} --shard {}/{} --out {}\n", study_command(study), missing->index,
                     missing->count, path);
}

}  // namespace

std::string study_status(const StudyFolder& folder) {
  const Study study = folder.study();
  const auto there = folder.shards();
  const std::int64_t count = there.empty() ? 1 : there.front().count;
  std::string text = fmt::format("{}: {} points, {} trials each, {}\n", folder.path().string(),
                                 study.points.size(), study.trials,
                                 count == 1 ? "one shard" : fmt::format("{} shards", count));
  std::map<std::string, std::int64_t> failures;
  std::optional<Shard> missing;
  bool running = false;
  for (std::int64_t index = 0; index < count; ++index) {
    const Shard shard{index, count};
    const ShardStatus status = status_of(folder, study, shard);
    const bool closed = std::filesystem::exists(folder.finished(shard)) &&
                        !std::filesystem::exists(folder.journal(shard));
    for (const auto& [cause, times] : status.failures) failures[cause] += times;
    text += fmt::format("  shard {}/{}: {} of {} trials, {}\n", index, count, status.known,
                        status.trials, state_of(status, closed));
    if (!closed && !missing) missing = shard;
    running = running || status.running;
  }
  for (const auto& [cause, times] : failures) {
    text += fmt::format("  failed {} times: {}\n", times, cause);
  }
  if (!failures.empty() && !missing) {
    text +=
        fmt::format("Failed trials again: honka study retry-failed {}\n", folder.path().string());
  }
  return text + next_step(folder, study, missing ? &*missing : nullptr, running);
}

}  // namespace honka::eval
