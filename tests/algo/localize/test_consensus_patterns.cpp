// The matcher consensus where places look alike: told so, and after a part of the search.
#include <catch2/catch.hpp>

#include "algo/localize/consensus/consensus.h"
#include "tests/algo/localize/consensus_world.h"

using namespace honka;
using namespace honka::test;

namespace {

/// Planted without an error: every place of it looks like every other.
Stems grid(int side) {
  Stems stems;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) stems.emplace_back(2.5 * i, 2.0 * j);
  }
  return stems;
}

}  // namespace

TEST_CASE("consensus: rows of another plantation are ambiguous, long before all is tried") {
  const ConsensusMatcher matcher = consensus_of(rows(30, 7));
  for (std::uint64_t k = 0; k < 4; ++k) {
    const auto answer = matcher.locate(sight(rows(30, 8), {0.06, 0.0, 0.0, 15.0}, k).stems);
    CHECK(answer.verdict == Verdict::kAmbiguous);
    CHECK(answer.margin < 14.0);
    CHECK(answer.candidates < 150'000);
  }
}

TEST_CASE("consensus: a grid without jitter is ambiguous, long before all is tried") {
  const ConsensusMatcher matcher = consensus_of(grid(30));
  const auto answer = matcher.locate(sight(grid(30), {0.02, 0.0, 0.0, 12.0}, 1).stems);
  CHECK(answer.verdict == Verdict::kAmbiguous);
  CHECK(answer.candidates < 600'000);
}
