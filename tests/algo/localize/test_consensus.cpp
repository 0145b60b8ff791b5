// The matcher consensus: worlds with a known answer, laws, refusals.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "algo/localize/consensus/consensus.h"
#include "algo/types/user_error.h"
#include "tests/algo/localize/cases.h"
#include "tests/algo/localize/consensus_world.h"

using namespace honka;
using namespace honka::test;

TEST_CASE("consensus: one frame without noise is found to the digits") {
  const Stems map = forest(900, 1);
  const ConsensusMatcher matcher = consensus_of(map);
  const Sighting seen = sight(map, {.noise_m = 0.0, .missed = 0.0, .false_share = 0.0}, 1);
  const auto answer = matcher.locate(seen.stems);
  REQUIRE(answer.accepted());
  CHECK(shift_between(answer.T_map_local, seen.T_map_local) < 1e-6);
  CHECK(answer.inliers == static_cast<int>(seen.stems.size()));
  CHECK(answer.margin > 100.0);
}

TEST_CASE("consensus: noise, missed and false stems of one frame") {
  const Stems map = forest(2200, 2);
  const ConsensusMatcher matcher = consensus_of(map);
  for (const SightingSettings& kind : {SightingSettings{0.15, 0.3, 0.1},  //
                                       SightingSettings{0.2, 0.5, 0.3}}) {
    for (std::uint64_t k = 0; k < 10; ++k) {
      const Sighting seen = sight(map, kind, k);
      const auto answer = matcher.locate(seen.stems);
      REQUIRE(answer.accepted());
      CHECK(is_right(answer.T_map_local, seen.T_map_local));
      REQUIRE(answer.covariance.has_value());
      // Three numbers within five standard deviations, all at once
      Eigen::Vector3d error;
      error << answer.T_map_local.translation_m - seen.T_map_local.translation_m,
          wrap_to_pi(answer.T_map_local.yaw_rad - seen.T_map_local.yaw_rad);
      CHECK(error.dot(answer.covariance->inverse() * error) < 33.0);
    }
  }
}

TEST_CASE("consensus: another forest is not in the map") {
  const ConsensusMatcher matcher = consensus_of(forest(900, 3));
  const Stems other = forest(900, 4);
  for (std::uint64_t k = 0; k < 5; ++k) {
    const auto answer = matcher.locate(sight(other, {0.05, 0.1, 0.05}, k).stems);
    CHECK(answer.verdict == Verdict::kNotInMap);
    CHECK(answer.margin < 10.0);
  }
}

TEST_CASE("consensus: a mirrored frame is refused") {
  const Stems map = forest(900, 5);
  Stems mirrored = sight(map, {0.0, 0.0, 0.0}, 1).stems;
  for (Eigen::Vector2d& p : mirrored) p.y() = -p.y();
  CHECK(consensus_of(map).locate(mirrored).verdict == Verdict::kNotInMap);
}

TEST_CASE("consensus: two copies of a stand are ambiguous, wherever they stand") {
  Stems map = forest(400, 6);
  const Sighting seen = sight(map, {0.05, 0.1, 0.05}, 1);
  REQUIRE(consensus_of(map).locate(seen.stems).accepted());
  const Stems once = map;
  for (const Eigen::Vector2d& p : once) map.push_back(p + Eigen::Vector2d(500.0, 20.0));
  CHECK(consensus_of(map).locate(seen.stems).verdict == Verdict::kAmbiguous);

  // A prior tells them apart
  const LocatePrior prior{seen.T_map_local.translation_m, 30.0};
  const auto answer = consensus_of(map).locate(seen.stems, prior);
  REQUIRE(answer.accepted());
  CHECK(is_right(answer.T_map_local, seen.T_map_local));
}

TEST_CASE("consensus: planted rows are solved or ambiguous, never wrong") {
  const Stems map = rows(20, 7);
  const ConsensusMatcher matcher = consensus_of(map);
  int solved = 0;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const Sighting seen = sight(map, {0.06, 0.1, 0.05, 12.0}, k);
    const auto answer = matcher.locate(seen.stems);
    solved += answer.accepted() ? 1 : 0;
    if (answer.accepted()) CHECK(is_right(answer.T_map_local, seen.T_map_local));
    CHECK(answer.verdict != Verdict::kNotInMap);
    CHECK_FALSE(matcher.locate(sight(rows(20, 8), {0.06, 0.1, 0.05, 12.0}, k).stems).accepted());
  }
  CHECK(solved >= 3);
}

TEST_CASE("consensus: a prior elsewhere refuses, a wide one does not matter") {
  const Stems map = forest(900, 9);
  const ConsensusMatcher matcher = consensus_of(map);
  const Sighting seen = sight(map, {0.1, 0.2, 0.1}, 1);
  const Eigen::Vector2d truth = seen.T_map_local.translation_m;
  const auto wide = matcher.locate(seen.stems, LocatePrior{truth, 1000.0});
  CHECK(shift_between(wide.T_map_local, matcher.locate(seen.stems).T_map_local) < 1e-9);
  const auto narrow = matcher.locate(seen.stems, LocatePrior{truth, 20.0});
  CHECK(narrow.accepted());
  CHECK(shift_between(wide.T_map_local, narrow.T_map_local) < 1e-9);
  CHECK(2 * narrow.candidates < wide.candidates);  // the active subset alone is tried
  const Eigen::Vector2d elsewhere = truth + Eigen::Vector2d(40.0, 0.0);
  CHECK_FALSE(matcher.locate(seen.stems, LocatePrior{elsewhere, 20.0}).accepted());
  CHECK_THROWS_AS(matcher.locate(seen.stems, LocatePrior{truth, 0.0}), UserError);
}

TEST_CASE("consensus: the reference cases, with no setting of their own") {
  const auto folder = shared_cases();
  if (!folder) {
    WARN("skipped: shared/data/localization_cases is not here");
    return;
  }
  for (const std::string set : {"exact", "easy"}) {
    const ConsensusMatcher matcher = consensus_of(read_stems(*folder / set / "map.csv"));
    const auto cases = read_json(*folder / ("cases_" + set + ".json"));
    REQUIRE(cases["cases"].size() == 52);
    for (const auto& one : cases["cases"]) {
      Stems stems;
      for (const auto& p : one["stems"]) stems.emplace_back(p[0].get<double>(), p[1].get<double>());
      const auto answer = matcher.locate(stems);
      REQUIRE(answer.accepted());
      const Eigen::Vector2d place(one["tx"].get<double>(), one["ty"].get<double>());
      CHECK(is_right(answer.T_map_local, {place, one["theta"].get<double>()}));
    }
  }
}
