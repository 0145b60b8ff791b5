#include <catch2/catch.hpp>
#include <limits>

#include "algo/odometry/sweep_order.h"

using namespace honka;

namespace {

Sweep sweep_at(double start_s, std::uint16_t range_ticks = 1000) {
  Sweep sweep;
  sweep.start_time_s = start_s;
  Return r;
  r.range_ticks = range_ticks;
  sweep.returns = {r};
  return sweep;
}

}  // namespace

TEST_CASE("sweeps a period apart follow each other") {
  SweepOrder order(vlp16());
  const auto first = order.judge(sweep_at(5.0));
  CHECK(first.cause == OdometryCause::kNone);
  CHECK(first.placed);
  CHECK(first.elapsed_s == 0.0);
  const auto second = order.judge(sweep_at(5.1));
  CHECK(second.cause == OdometryCause::kNone);
  CHECK(second.elapsed_s == Approx(0.1));
}

TEST_CASE("a gap is more than one and a half periods") {
  SweepOrder order(vlp16());
  static_cast<void>(order.judge(sweep_at(0.0)));
  CHECK(order.judge(sweep_at(0.149)).cause == OdometryCause::kNone);
  const auto gap = order.judge(sweep_at(0.349));
  CHECK(gap.cause == OdometryCause::kGap);
  CHECK(gap.placed);
  CHECK(gap.elapsed_s == Approx(0.2));
}

TEST_CASE("repeated and reversed times have no place, and change nothing") {
  SweepOrder order(vlp16());
  static_cast<void>(order.judge(sweep_at(1.0)));
  static_cast<void>(order.judge(sweep_at(1.1)));
  const auto repeated = order.judge(sweep_at(1.1));
  CHECK(repeated.cause == OdometryCause::kRepeatedTime);
  CHECK_FALSE(repeated.placed);
  const auto reversed = order.judge(sweep_at(1.0));
  CHECK(reversed.cause == OdometryCause::kReversedTime);
  CHECK_FALSE(reversed.placed);
  CHECK(order.judge(sweep_at(1.2)).elapsed_s == Approx(0.1));
}

TEST_CASE("times and azimuths that are no numbers have no place") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  SweepOrder order(vlp16());
  for (const double bad : {nan, inf, -inf}) {
    CHECK(order.judge(sweep_at(bad)).cause == OdometryCause::kNotFinite);
    Sweep azimuth = sweep_at(0.0);
    azimuth.start_azimuth_rad = bad;
    CHECK(order.judge(azimuth).cause == OdometryCause::kNotFinite);
    CHECK_FALSE(order.judge(azimuth).placed);
  }
  CHECK(order.judge(sweep_at(0.0)).cause == OdometryCause::kNone);
}

TEST_CASE("a scan without a return is empty, and placed") {
  SweepOrder order(vlp16());
  Sweep none = sweep_at(0.0);
  none.returns.clear();
  CHECK(order.judge(none).cause == OdometryCause::kEmptyScan);
  const auto misses = order.judge(sweep_at(0.1, 0));
  CHECK(misses.cause == OdometryCause::kEmptyScan);
  CHECK(misses.placed);
  CHECK(order.judge(sweep_at(0.2)).cause == OdometryCause::kNone);
}
