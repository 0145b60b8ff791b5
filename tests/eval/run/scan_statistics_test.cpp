#include "eval/run/scan_statistics.h"

#include <catch2/catch.hpp>

using namespace honka;
using honka::eval::ScanStatistics;
using sim::Part;

namespace {

/// A sweep whose shots met these parts, trees and ranges.
sim::TruthfulSweep sweep_of(const std::vector<sim::ReturnTruth>& truth) {
  sim::TruthfulSweep sweep;
  sweep.truth = truth;
  sweep.sweep.returns.resize(truth.size());
  return sweep;
}

constexpr sim::ReturnTruth stem(std::int32_t tree, float range_m) {
  return {{tree, Part::kStem}, range_m};
}
constexpr sim::ReturnTruth kMiss = {{-1, Part::kNone}, 0.0F};
constexpr sim::ReturnTruth kGround = {{-1, Part::kGround}, 4.0F};
constexpr sim::ReturnTruth kBranch = {{7, Part::kBranch}, 8.0F};

}  // namespace

TEST_CASE("returns are counted by part and stems by their mean range") {
  ScanStatistics statistics;
  // Tree 1 three times about 9 m, tree 2 once at 12 m; tree 7 shows branches alone.
  const std::vector one = {sweep_of({stem(1, 8.0F), stem(1, 9.0F), stem(1, 11.5F), kMiss, kGround,
                                     stem(2, 12.0F), kBranch, kGround})};
  statistics.add(one);
  CHECK(statistics.key_frames == 1);
  CHECK(statistics.shots == 8);
  CHECK(statistics.returns == 7);
  CHECK(statistics.stems_hit == std::array<std::int64_t, 4>{1, 1, 0, 0});
  CHECK(statistics.stem_hits == std::array<std::int64_t, 4>{3, 1, 0, 0});
  CHECK(statistics.share_on(Part::kStem) == Approx(4.0 / 7.0));
  CHECK(statistics.share_on(Part::kGround) == Approx(2.0 / 7.0));
  CHECK(statistics.share_on(Part::kWall) == 0.0);
  CHECK(statistics.hits_per_stem(0) == 3.0);
  CHECK(statistics.hits_per_stem() == 2.0);
}

TEST_CASE("sweeps of one key frame count a stem once, key frames count it again") {
  ScanStatistics statistics;
  const std::vector both = {sweep_of({stem(1, 25.0F)}), sweep_of({stem(1, 25.0F), stem(1, 25.0F)})};
  statistics.add(both);
  CHECK(statistics.hits_per_stem(2) == 3.0);
  statistics.add(both);
  CHECK(statistics.key_frames == 2);
  CHECK(statistics.stems_hit[2] == 2);
  CHECK(statistics.hits_per_stem(2) == 3.0);
}

TEST_CASE("bins are closed below and open above, stems beyond the last count in none") {
  ScanStatistics statistics;
  const std::vector one = {
      sweep_of({stem(1, 10.0F), stem(2, 30.0F), stem(3, 46.9F), stem(4, 47.0F)})};
  statistics.add(one);
  CHECK(statistics.stems_hit == std::array<std::int64_t, 4>{0, 1, 0, 2});
  CHECK(statistics.returns_by_part[static_cast<std::size_t>(Part::kStem)] == 4);
}

TEST_CASE("statistics of nothing are 0") {
  const ScanStatistics statistics;
  CHECK(statistics.hits_per_stem() == 0.0);
  CHECK(statistics.hits_per_stem(1) == 0.0);
  CHECK(statistics.share_on(Part::kStem) == 0.0);
}
