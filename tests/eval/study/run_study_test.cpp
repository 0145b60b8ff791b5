// A study gives the same digits however it is run, and loses nothing whatever its trials do.
#include "eval/study/run_study.h"

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/study/journal.h"
#include "tests/eval/study/fake_study.h"

namespace {

using namespace honka::eval;
using honka::test::fake_study;
using honka::test::TemporaryFolder;

/// Digest of a study run in so many shards and threads, the later shards first.
std::string digest_of_study(const Study& study, const std::filesystem::path& path,
                            std::int64_t shards, int threads) {
  const StudyFolder folder(path);
  for (std::int64_t index = shards; index-- > 0;) {
    static_cast<void>(run_shard(folder, study, {index, shards}, threads));
  }
  return merge_study(folder, study, "honka study fake.toml").digest;
}

}  // namespace

TEST_CASE("one study, one digest: threads, shards and order do not matter") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 60);
  const std::string plain = digest_of_study(study, folder / "plain", 1, 1);
  CHECK(digest_of_study(study, folder / "threads", 1, 3) == plain);
  CHECK(digest_of_study(study, folder / "shards", 7, 2) == plain);
  Study other = fake_study(folder, 61);
  CHECK(digest_of_study(other, folder / "other", 1, 1) != plain);
}

TEST_CASE("more trials are added to what is there, and give what they give at once") {
  const TemporaryFolder folder;
  const Study few = fake_study(folder, 20), many = fake_study(folder, 50);
  const std::string at_once = digest_of_study(many, folder / "at_once", 3, 2);
  static_cast<void>(digest_of_study(few, folder / "grown", 3, 2));
  const StudyFolder grown(folder / "grown");
  std::int64_t run_now = 0;
  for (std::int64_t index = 0; index < 3; ++index) {
    run_now += run_shard(grown, many, {index, 3}, 2).run_now;
  }
  CHECK(run_now == 2 * 30);
  CHECK(merge_study(grown, many, "").digest == at_once);
}

TEST_CASE("trials that throw, crash, hang or take all memory are rows with their cause") {
  const TemporaryFolder folder;
  Study study = fake_study(folder, 10, false);
  study.base.scenario.study.time_limit_s = 2.0;
#ifndef __SANITIZE_ADDRESS__
  study.base.scenario.study.memory_limit_mb = 400;
  constexpr std::int64_t kTrials = 10, kFailed = 4;
#else
  study.trials = 6;  // the sanitizer's own memory leaves no room for a limit
  constexpr std::int64_t kTrials = 6, kFailed = 3;
#endif
  const StudyFolder study_folder(folder / "out");
  const ShardOutcome outcome = run_shard(study_folder, study, {0, 1}, 2);
  CHECK(outcome.trials == 2 * kTrials);
  CHECK(outcome.failed == kFailed);
  const auto records = records_of(study, read_shard(study_folder, study, {0, 1}));
  const auto at = [&](std::int64_t trial) {
    return records.at(static_cast<std::size_t>(kTrials + trial));
  };
  CHECK(at(2).status == TrialStatus::kDone);
  CHECK(at(3).status == TrialStatus::kThrew);
  CHECK(at(3).cause == "no forest here");
  CHECK(at(4).status == TrialStatus::kCrashed);
  CHECK_THAT(at(4).cause, Catch::Contains("fake: check failed"));
  CHECK(at(5).status == TrialStatus::kTimedOut);
  CHECK_THAT(at(5).cause, Catch::Contains("study.time_limit_s"));
  if (kTrials > 6) {
    CHECK(at(6).status == TrialStatus::kOutOfMemory);
    CHECK(at(7).status == TrialStatus::kDone);
  }
  CHECK(at(5).results.empty());
}

TEST_CASE("failed trials, and no others, are run again on request") {
  const TemporaryFolder folder;
  Study study = fake_study(folder, 5, false);
  const StudyFolder study_folder(folder / "out");
  CHECK(run_shard(study_folder, study, {0, 1}, 1).failed == 2);
  const Study mended = fake_study(folder, 5);
  const ShardOutcome outcome = run_shard(study_folder, mended, {0, 1}, 1, true);
  CHECK(outcome.run_now == 2);
  CHECK(outcome.failed == 0);
  CHECK(merge_study(study_folder, mended, "").digest ==
        digest_of_study(mended, folder / "plain", 1, 1));
}

TEST_CASE("a study that goes on from a journal runs what is missing only") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 40);
  const std::string plain = digest_of_study(study, folder / "plain", 1, 1);
  const StudyFolder cut(folder / "cut");
  cut.enter(study, {0, 1});
  {
    Journal journal(cut.journal({0, 1}), journal_title(study, {0, 1}), [](const TrialRecord&) {});
    for (std::int64_t trial = 0; trial < 30; ++trial) {
      TrialRecord record;
      record.id = {1, trial};
      record.results = run_trial(study, record.id);
      journal.append(record);
    }
  }
  CHECK_THROWS_WITH(merge_study(cut, study, ""), Catch::Contains("is not finished"));
  CHECK(run_shard(cut, study, {0, 1}, 2).run_now == 50);
  CHECK(merge_study(cut, study, "").digest == plain);
  CHECK(run_shard(cut, study, {0, 1}, 2).run_now == 0);
}

TEST_CASE("a trial alone gives what it gives in the study") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 12);
  const StudyFolder study_folder(folder / "out");
  static_cast<void>(run_shard(study_folder, study, {0, 1}, 2));
  for (const TrialRecord& record : records_of(study, read_shard(study_folder, study, {0, 1}))) {
    const auto alone = run_trial(study, record.id);
    REQUIRE(alone.size() == record.results.size());
    for (std::size_t m = 0; m < alone.size(); ++m) {
      CHECK(alone[m].method == record.results[m].method);
      CHECK(alone[m].values.front() == record.results[m].values.front());
    }
  }
}

TEST_CASE("a point whose intervals are narrow ends early, in shards at the same trial") {
  const TemporaryFolder folder;
  Study study = fake_study(folder, 1000);
  study.base.scenario.study.stop_half_width = 0.06;
  const StudyFolder alone(folder / "alone");
  const ShardOutcome outcome = run_shard(alone, study, {0, 1}, 2);
  CHECK(outcome.trials < 800);
  CHECK(outcome.trials >= 2 * 100);
  CHECK(merge_study(alone, study, "").digest == digest_of_study(study, folder / "shards", 3, 2));
}
