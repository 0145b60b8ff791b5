// The matcher consensus: motions and orders that must not matter, odd and bad input, the index.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <thread>

#include "algo/localize/consensus/consensus.h"
#include "algo/types/user_error.h"
#include "tests/algo/localize/consensus_world.h"

using namespace honka;
using namespace honka::test;

namespace {

Stems moved(const Stems& stems, const Pose2& T) {
  Stems list;
  for (const Eigen::Vector2d& p : stems) list.push_back(T * p);
  return list;
}

}  // namespace

TEST_CASE("consensus: orders of the lists do not matter") {
  const Stems map = forest(900, 11);
  const Sighting seen = sight(map, {0.1, 0.2, 0.1}, 1);
  const auto answer = consensus_of(map).locate(seen.stems);
  REQUIRE(answer.accepted());
  const Stems map_back(map.rbegin(), map.rend());
  const Stems seen_back(seen.stems.rbegin(), seen.stems.rend());
  const auto again = consensus_of(map_back).locate(seen_back);
  REQUIRE(again.accepted());
  CHECK(shift_between(answer.T_map_local, again.T_map_local) < 1e-7);
  CHECK(again.inliers == answer.inliers);
}

TEST_CASE("consensus: motions of map and frame move the answer with them, UTM included") {
  const Stems map = forest(900, 12);
  const Sighting seen = sight(map, {0.1, 0.2, 0.1}, 1);
  const auto answer = consensus_of(map).locate(seen.stems);
  REQUIRE(answer.accepted());
  const Pose2 of_map{{385000.25, 6672000.75}, 2.1};
  const Pose2 of_frame{{-4.0, 30.0}, -0.7};
  const auto again = consensus_of(moved(map, of_map)).locate(moved(seen.stems, of_frame));
  REQUIRE(again.accepted());
  const Pose2 expected = of_map * answer.T_map_local * of_frame.inverse();
  CHECK(shift_between(again.T_map_local, expected) < 1e-5);
}

TEST_CASE("consensus: too few, equal or collinear stems are told") {
  const Stems map = forest(400, 13);
  const ConsensusMatcher matcher = consensus_of(map);
  Stems line;
  for (int i = 0; i < 30; ++i) line.emplace_back(i, 2.0 * i);
  const Stems two(map.begin(), map.begin() + 2);
  const Stems same(30, Eigen::Vector2d(3.0, 4.0));
  for (const Stems& local : {Stems{}, two, same, line}) {
    const auto answer = matcher.locate(local);
    CHECK(answer.verdict == Verdict::kTooFewStems);
    CHECK(answer.stems == static_cast<int>(local.size()));
  }
  for (const std::ptrdiff_t n : {3, 4, 5}) {
    const Stems few(map.begin(), map.begin() + n);
    CHECK_FALSE(matcher.locate(sight(few, {0.1}, 1).stems).accepted());
  }
}

TEST_CASE("consensus: stems listed twice are no new witnesses") {
  const Stems map = forest(900, 14);
  const Sighting seen = sight(map, {0.1, 0.2, 0.1}, 1);
  Stems twice = seen.stems;
  twice.insert(twice.end(), seen.stems.begin(), seen.stems.end());
  const ConsensusMatcher matcher = consensus_of(map);
  const auto answer = matcher.locate(seen.stems);
  const auto again = matcher.locate(twice);
  CHECK(again.inliers == answer.inliers);
  CHECK(again.margin == Approx(answer.margin));
}

TEST_CASE("consensus: a map smaller than the frame, and a stray stem far away") {
  const Sighting seen = sight(forest(900, 15), {0.0}, 1);
  const Stems part(seen.stems.begin(), seen.stems.begin() + 40);
  const auto answer = consensus_of(part).locate(seen.stems);
  REQUIRE(answer.accepted());
  CHECK(answer.T_map_local.translation_m.norm() < 1e-6);
  Stems strayed = part;
  strayed.emplace_back(7.0e6, -4.0e5);
  CHECK(consensus_of(strayed).locate(part).accepted());
}

TEST_CASE("consensus: what is not a number or not a map is refused") {
  Stems stems = forest(100, 16);
  const ConsensusMatcher matcher = consensus_of(stems);
  CHECK_THROWS_WITH(consensus_of({{0.0, 0.0}, {1.0, 0.0}}), Catch::Contains("2 stems"));
  CHECK_THROWS_AS(consensus_of({}), UserError);
  stems[30].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(matcher.locate(stems), Catch::Contains("point 31 of 100"));
  CHECK_THROWS_WITH(consensus_of(stems), Catch::Contains("point 31 of 100"));
  const auto index = std::make_shared<ConsensusIndex>(forest(50, 1));
  ConsensusSettings wrong;
  wrong.stem_sigma_m = 0.0;
  CHECK_THROWS_AS(ConsensusMatcher(index, wrong), UserError);
}

TEST_CASE("consensus: an index comes back from its bytes") {
  const Stems map = forest(500, 17);
  const ConsensusIndex index(map);
  const auto bytes = index.to_bytes();
  const auto back = std::make_shared<ConsensusIndex>(ConsensusIndex::from_bytes(bytes));
  CHECK(back->hash() == map_hash(map));
  CHECK(back->to_bytes() == bytes);
  const Sighting seen = sight(map, {0.1, 0.2, 0.1}, 1);
  const auto answer = consensus_of(map).locate(seen.stems);
  const auto again = ConsensusMatcher(back, {}).locate(seen.stems);
  CHECK(again.T_map_local.translation_m == answer.T_map_local.translation_m);
  CHECK(again.margin == answer.margin);
}

TEST_CASE("consensus: damaged, short and foreign bytes are refused with the reason") {
  const auto bytes = ConsensusIndex(forest(60, 18)).to_bytes();
  const auto with = [&](std::size_t at) {
    auto copy = bytes;
    copy[at] ^= 4U;
    return copy;
  };
  CHECK_THROWS_WITH(ConsensusIndex::from_bytes(with(3)), Catch::Contains("not the index"));
  CHECK_THROWS_WITH(ConsensusIndex::from_bytes(with(8)), Catch::Contains("version"));
  for (const std::size_t at :
       {std::size_t{40}, std::size_t{57}, bytes.size() / 2, bytes.size() - 1}) {
    CHECK_THROWS_WITH(ConsensusIndex::from_bytes(with(at)), Catch::Contains("damaged"));
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{20}, bytes.size() - 1}) {
    CHECK_THROWS_AS(ConsensusIndex::from_bytes(std::span(bytes).first(size)), UserError);
  }
}

TEST_CASE("consensus: the map's hash knows every stem and its place") {
  Stems map = forest(40, 19);
  const auto hash = map_hash(map);
  CHECK(map_hash(map) == hash);
  map[20].x() += 1e-6;
  CHECK(map_hash(map) != hash);
  map[20].x() -= 1e-6;
  map.pop_back();
  CHECK(map_hash(map) != hash);
}

TEST_CASE("consensus: threads give the digits that one gives") {
  const Stems map = forest(900, 20);
  const ConsensusMatcher matcher = consensus_of(map);
  std::vector<LocateResult> together(4), alone(4);
  const auto run = [&](std::vector<LocateResult>& into, std::size_t k) {
    into[k] = matcher.locate(sight(map, {0.15, 0.3, 0.1}, k).stems);
  };
  for (std::size_t k = 0; k < 4; ++k) run(alone, k);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 4; ++k) threads.emplace_back([&, k] { run(together, k); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(together[k].T_map_local.translation_m == alone[k].T_map_local.translation_m);
    CHECK(together[k].margin == alone[k].margin);
  }
}
