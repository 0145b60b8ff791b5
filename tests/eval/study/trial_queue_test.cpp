#include "eval/study/trial_queue.h"

#include <catch2/catch.hpp>
#include <set>

namespace {

using namespace honka::eval;

TrialBatch batch_of(std::int64_t point, std::int64_t trials) {
  TrialBatch batch;
  for (std::int64_t trial = 0; trial < trials; ++trial) batch.push_back({point, trial});
  return batch;
}

}  // namespace

TEST_CASE("each worker stays in its batch, and every trial is handed out once") {
  TrialQueue queue({batch_of(0, 3), batch_of(1, 3)}, 2);
  std::set<TrialId> seen;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t worker = 0; worker < 2; ++worker) {
      const auto id = queue.next(worker);
      REQUIRE(id);
      CHECK(id->point == static_cast<std::int64_t>(worker));
      CHECK(seen.insert(*id).second);
      queue.ended(worker, 1.0);
    }
  }
  CHECK_FALSE(queue.next(0));
  CHECK_FALSE(queue.next(1));
}

TEST_CASE("a worker without a batch takes half of another's where its world is cheap") {
  TrialQueue queue({batch_of(0, 12)}, 2);
  for (int trial = 0; trial < 4; ++trial) {
    REQUIRE(queue.next(0));
    queue.ended(0, 1.0);  // the first took no longer than the others: the world costs nothing
  }
  CHECK(queue.next(1) == TrialId{0, 8});
  CHECK(queue.next(0) == TrialId{0, 4});
}

TEST_CASE("it leaves a batch alone whose world costs more than the trials left") {
  TrialQueue queue({batch_of(0, 12)}, 2);
  for (int trial = 0; trial < 4; ++trial) {
    REQUIRE(queue.next(0));
    queue.ended(0, trial == 0 ? 100.0 : 1.0);
  }
  CHECK_FALSE(queue.next(1));
  CHECK(queue.next(0) == TrialId{0, 4});
}
