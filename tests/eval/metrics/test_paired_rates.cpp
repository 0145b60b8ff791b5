#include <catch2/catch.hpp>

#include "eval/metrics/paired_rates.h"

using namespace honka::eval;

TEST_CASE("paired rate intervals against published values") {
  // Newcombe 1998, table II, method 10: 36, 12, 2, 0.
  const auto published = paired_rate_interval({36, 12, 2, 0});
  REQUIRE(published);
  CHECK(published->low == Approx(0.0569).margin(5e-5));
  CHECK(published->high == Approx(0.3404).margin(5e-5));
}

TEST_CASE("methods that never differ have an interval about zero that is no point") {
  const auto interval = paired_rate_interval({54, 0, 0, 0});
  REQUIRE(interval);
  // Wilson's of 54 of 54 goes down to 1/(1 + z²/54) = 0.93358, for both methods.
  CHECK(interval->low == Approx(-0.0664).margin(5e-5));
  CHECK(interval->high == Approx(0.0664).margin(5e-5));
  CHECK_FALSE(paired_rate_interval({}));
}

TEST_CASE("swapping the methods mirrors the interval, dependent trials widen it") {
  const auto ab = paired_rate_interval({60, 25, 5, 10});
  const auto ba = paired_rate_interval({60, 5, 25, 10});
  CHECK(ab->low == Approx(-ba->high));
  CHECK(ab->high == Approx(-ba->low));
  const auto fourfold = paired_rate_interval({240, 100, 20, 40}, 2.0);
  CHECK(fourfold->low == Approx(ab->low));
  CHECK(fourfold->high == Approx(ab->high));
}

TEST_CASE("McNemar's exact probability, by hand") {
  CHECK(mcnemar_exact({9, 0, 0, 3}) == 1.0);
  CHECK(mcnemar_exact({0, 5, 0, 0}) == Approx(2.0 / 32.0));
  CHECK(mcnemar_exact({7, 1, 5, 7}) == Approx(2.0 * (1.0 + 6.0) / 64.0));
  CHECK(mcnemar_exact({7, 3, 3, 7}) == 1.0);  // 2 · 42/64, and no more than 1
  CHECK(mcnemar_exact({0, 60000, 40000, 0}) < 1e-300);
  CHECK(mcnemar_exact({0, 50000, 50000, 0}) == 1.0);
}
