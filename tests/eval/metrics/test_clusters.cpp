#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "eval/metrics/clusters.h"

using namespace honka::eval;

namespace {

struct ClusteredValues {
  std::vector<double> values;
  std::vector<std::int64_t> clusters;
};

/// Values of 0 or 1: so many ones of so many trials in each cluster.
ClusteredValues ones_of(const std::vector<std::pair<int, int>>& ones_and_trials) {
  ClusteredValues all;
  for (std::size_t c = 0; c < ones_and_trials.size(); ++c) {
    for (int k = 0; k < ones_and_trials[c].second; ++k) {
      all.values.push_back(k < ones_and_trials[c].first ? 1.0 : 0.0);
      all.clusters.push_back(static_cast<std::int64_t>(c));
    }
  }
  return all;
}

ClusterSpread spread_of(const ClusteredValues& all) {
  return cluster_spread(all.values, all.clusters);
}

}  // namespace

TEST_CASE("the design effect of clusters, by hand") {
  // Two worlds of ten trials, 2 and 6 right: p = 0.4, s − p m = ∓2, so between
  // 2/1 · 8/400 = 0.04; within 20 · 0.24/(20 · 19) = 0.0126316; the ratio is 3.1667.
  const ClusterSpread spread = spread_of(ones_of({{2, 10}, {6, 10}}));
  CHECK(spread.clusters == 2);
  CHECK(spread.design_effect == Approx(19.0 / 6.0));
  CHECK(spread.widening == Approx(std::sqrt(19.0 / 6.0) * 12.7062047 / 1.9599640));
  // Each world all right or all wrong: ten observations in a hundred trials.
  const ClusterSpread whole = spread_of(
      ones_of({{10, 10}, {0, 10}, {10, 10}, {0, 10}, {10, 10}, {0, 10}, {10, 10}, {0, 10}}));
  CHECK(whole.design_effect == Approx(10.0 * 79.0 / 80.0 * 8.0 / 7.0));
}

TEST_CASE("worlds that differ less than chance make nothing narrower") {
  const ClusterSpread equal = spread_of(ones_of({{5, 10}, {5, 10}, {5, 10}}));
  CHECK(equal.design_effect == Approx(0.0).margin(1e-12));
  CHECK(equal.widening == 1.0);
}

TEST_CASE("without shared worlds, with one world or equal values there is no design effect") {
  for (const ClusteredValues& all :
       {ones_of({{1, 1}, {0, 1}, {1, 1}, {1, 1}}), ones_of({{3, 10}}),
        ones_of({{10, 10}, {10, 10}}), ones_of({{0, 10}, {0, 10}}), ones_of({})}) {
    CHECK(spread_of(all).design_effect == 1.0);
    CHECK(spread_of(all).widening == 1.0);
  }
}

TEST_CASE("Student's points against tables") {
  CHECK(student_975(1) == Approx(12.7062).margin(5e-5));
  CHECK(student_975(3) == Approx(3.1824).margin(5e-5));
  CHECK(student_975(9) == Approx(2.2622).margin(5e-5));
  CHECK(student_975(10) == Approx(2.2281).margin(5e-5));
  CHECK(student_975(19) == Approx(2.0930).margin(5e-5));
  CHECK(student_975(120) == Approx(1.9799).margin(5e-5));
  CHECK(student_975(100000000) == Approx(1.959964).margin(1e-6));
}

TEST_CASE("a widened rate interval is Wilson's of fewer trials") {
  const auto plain = clustered_rate_interval(81, 263, 1.0);
  CHECK(plain->low == wilson_interval(81, 263)->low);
  const auto wide = clustered_rate_interval(80, 400, 2.0);  // as 20 of 100
  CHECK(wide->low == Approx(wilson_interval(20, 100)->low));
  CHECK(wide->high == Approx(wilson_interval(20, 100)->high));
  CHECK_FALSE(clustered_rate_interval(0, 0, 2.0));
  CHECK(clustered_rate_interval(0, 40, 2.0)->low == 0.0);
  CHECK(clustered_rate_interval(40, 40, 2.0)->high == 1.0);
}

TEST_CASE("an interval widens about its middle and not below what can be") {
  const Interval wide = widened({0.9, 1.3}, 1.0, 2.0, 0.0);
  CHECK(wide.low == Approx(0.8));
  CHECK(wide.high == Approx(1.6));
  CHECK(widened({0.2, 1.3}, 1.0, 2.0, 0.0).low == 0.0);
}
