#include "eval/study/shard.h"

#include <catch2/catch.hpp>
#include <set>

#include "algo/types/user_error.h"
#include "tests/eval/study/fake_study.h"

namespace {

using namespace honka::eval;
using honka::test::fake_study;
using honka::test::TemporaryFolder;

std::vector<TrialId> trials_in(const Study& study, const Shard& shard) {
  std::vector<TrialId> all;
  for (const TrialBatch& batch : batches_of(study, shard)) {
    all.insert(all.end(), batch.begin(), batch.end());
  }
  return all;
}

}  // namespace

TEST_CASE("a shard is written i/N, from 0") {
  CHECK(parse_shard("2/7") == Shard{2, 7});
  CHECK(parse_shard("0/1") == Shard{0, 1});
  for (const char* text : {"", "7", "7/7", "-1/7", "1/0", "a/2", "1/2x", " 1/2", "1/2/3"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_shard(text), honka::UserError);
  }
}

TEST_CASE("shards share the trials out: each in one, none left over, about as many in each") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 500);
  for (const std::int64_t count : {1, 2, 3, 7, 16}) {
    std::set<TrialId> seen;
    for (std::int64_t index = 0; index < count; ++index) {
      const auto trials = trials_in(study, {index, count});
      for (const TrialId id : trials) CHECK(seen.insert(id).second);
      const double even = 1000.0 / static_cast<double>(count);
      CHECK(std::abs(static_cast<double>(trials.size()) - even) < 0.4 * even);
    }
    CHECK(seen.size() == 1000);
  }
}

TEST_CASE("a trial stays in its shard when a study gets more trials") {
  const TemporaryFolder folder;
  const Study few = fake_study(folder, 100), many = fake_study(folder, 300);
  for (std::int64_t index = 0; index < 5; ++index) {
    const auto later = trials_in(many, {index, 5});
    const std::set<TrialId> there(later.begin(), later.end());
    for (const TrialId id : trials_in(few, {index, 5})) CHECK(there.contains(id));
  }
}

TEST_CASE("the trials of a batch are in one world of one point") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 100);
  for (const TrialBatch& batch : batches_of(study, {1, 3})) {
    for (const TrialId id : batch) {
      CHECK(id.point == batch.front().point);
      CHECK(id.trial % 3 == batch.front().trial % 3);
    }
  }
}

TEST_CASE("where points may stop, a round is complete before the next one begins") {
  const TemporaryFolder folder;
  Study study = fake_study(folder, 250);
  study.base.scenario.study.stop_half_width = 0.05;
  std::int64_t round = 0;
  for (const TrialId id : trials_in(study, {0, 1})) {
    if (id.point != 0) continue;
    CHECK(id.trial / 100 >= round);
    round = id.trial / 100;
  }
  CHECK(round == 2);
}
