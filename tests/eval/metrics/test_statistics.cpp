#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "eval/metrics/statistics.h"

using namespace honka::eval;

using Values = std::vector<double>;

TEST_CASE("the statistics of nothing are nothing") {
  const Values none;
  CHECK_FALSE(mean(none));
  CHECK_FALSE(standard_deviation(none));
  CHECK_FALSE(standard_deviation(Values{3.0}));
  CHECK_FALSE(median(none));
  CHECK_FALSE(percentile(none, 95.0));
  CHECK_FALSE(minimum(none));
  CHECK_FALSE(maximum(none));
  CHECK_FALSE(rmse(none));
  CHECK_FALSE(pooled_rmse(std::vector<Values>{{}, {}}));
  CHECK_FALSE(wilson_interval(0, 0));
  CHECK_FALSE(bootstrap_mean(none));
  CHECK_FALSE(bootstrap_mean(Values{1.0}));
  CHECK_FALSE(paired_difference(none, none));
}

TEST_CASE("statistics worked out by hand") {
  const Values values = {4.0, 1.0, 3.0, 2.0};
  CHECK(*mean(values) == 2.5);
  CHECK(*standard_deviation(values) == Approx(std::sqrt(5.0 / 3.0)));
  CHECK(*median(values) == 2.5);
  CHECK(*median(Values{9.0, 1.0, 5.0}) == 5.0);
  CHECK(*percentile(values, 0.0) == 1.0);
  CHECK(*percentile(values, 100.0) == 4.0);
  CHECK(*percentile(values, 95.0) == Approx(3.85));  // numpy.percentile([1,2,3,4], 95)
  CHECK(*minimum(values) == 1.0);
  CHECK(*maximum(values) == 4.0);
  CHECK(*rmse(Values{3.0, -4.0}) == Approx(std::sqrt(12.5)));
  CHECK(*mean(Values{-1.0}) == -1.0);
  CHECK(*percentile(Values{7.0}, 95.0) == 7.0);
}

TEST_CASE("a pooled RMSE is not the mean of RMSEs") {
  const std::vector<Values> trials = {{1.0}, {3.0, 3.0, 3.0}};
  CHECK(*pooled_rmse(trials) == Approx(std::sqrt(28.0 / 4.0)));  // the mean of RMSEs is 2
}

TEST_CASE("Wilson intervals against published values") {
  // Newcombe 1998, table I: 81/263, 15/148, 0/20, 1/29 (score method without correction).
  const auto check = [](int successes, int trials, double low, double high) {
    const auto interval = wilson_interval(successes, trials);
    REQUIRE(interval);
    CHECK(interval->low == Approx(low).margin(5e-5));
    CHECK(interval->high == Approx(high).margin(5e-5));
  };
  check(81, 263, 0.2553, 0.3662);
  check(15, 148, 0.0624, 0.1605);
  check(0, 20, 0.0, 0.1611);
  check(1, 29, 0.0061, 0.1718);
  check(20, 20, 1.0 - 0.1611, 1.0);
}

TEST_CASE("bootstrap intervals have the width of the normal ones and fixed digits") {
  honka::RandomStream random(11, "values");
  Values values;
  for (int i = 0; i < 400; ++i) values.push_back(random.normal(5.0, 2.0));
  const auto interval = bootstrap_mean(values);
  REQUIRE(interval);
  const double half = 1.96 * *standard_deviation(values) / 20.0;
  CHECK(interval->low == Approx(*mean(values) - half).margin(0.1 * half));
  CHECK(interval->high == Approx(*mean(values) + half).margin(0.1 * half));
  CHECK(bootstrap_mean(values)->low == interval->low);
  BootstrapSettings other;
  other.seed = 2;
  CHECK(bootstrap_mean(values, other)->low != interval->low);
}

TEST_CASE("blocks that depend on each other widen the interval") {
  // 10 stands of 100 windows, each all right or all wrong: ten observations, not a thousand.
  std::vector<Block> stands, windows;
  for (int stand = 0; stand < 10; ++stand) {
    const double right = stand % 2;
    stands.push_back({100.0 * right, 100.0});
    for (int k = 0; k < 100; ++k) windows.push_back({right, 1.0});
  }
  stands.push_back({0.0, 0.0});  // an empty block adds nothing
  const auto wide = bootstrap_ratio(stands);
  const auto narrow = bootstrap_ratio(windows);
  REQUIRE(wide);
  CHECK(wide->high - wide->low == Approx(0.6).margin(0.11));  // binomial of 10 at 1/2
  CHECK(narrow->high - narrow->low == Approx(0.062).margin(0.008));
}

TEST_CASE("a paired difference takes out what trials share") {
  const Values a = {10.1, 20.2, 30.1, 40.2}, b = {10.0, 20.0, 30.0, 40.0};
  const auto difference = paired_difference(a, b);
  REQUIRE(difference);
  CHECK(difference->mean == Approx(0.15));
  CHECK(*difference->standard_deviation == Approx(std::sqrt(0.01 / 3.0)));
  CHECK(difference->n == 4);
  CHECK(difference->interval->low >= 0.1 - 1e-12);
  CHECK(difference->interval->high <= 0.2 + 1e-12);
}
