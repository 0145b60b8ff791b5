#include "eval/study/study_statistics.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "eval/study/study_json.h"
#include "tests/eval/study/hand_study.h"

using namespace honka::eval;
using honka::test::failed_record;
using honka::test::hand_record;
using honka::test::hand_study;
using honka::test::hand_table;
using honka::test::HandAnswer;

namespace {

std::vector<int> ones_then_zeros(std::size_t ones, std::size_t trials) {
  std::vector<int> flags(trials, 0);
  std::fill(flags.begin(), flags.begin() + static_cast<std::ptrdiff_t>(ones), 1);
  return flags;
}

/// Four trials: two right, one refused, one that threw.
Table four_trials(const Study& study) {
  const HandAnswer three{1.0, 0.0, 3.0, 1.0, 8.0, 1.0}, four{1.0, 0.0, 4.0, 2.0, 10.0, 3.0};
  const HandAnswer none{0.0, 0.0, 0.0, 0.0, 3.0, 2.0};
  return study_table(study, {failed_record({0, 2}, TrialStatus::kThrew, "no forest"),
                             hand_record({0, 0}, three, four), hand_record({0, 3}, none, three),
                             hand_record({0, 1}, four, three)});
}

}  // namespace

TEST_CASE("figures of a point by hand, a failed trial counts as 0 and has no error") {
  const Study study = hand_study(4, 4);
  const StudySummary summary = summarize_study(study, four_trials(study));
  REQUIRE(summary.cells.size() == 2);
  const CellSummary& plain = summary.cells[0];
  CHECK(plain.trials == 4);
  CHECK(plain.failed() == 1);
  CHECK(plain.failed_by.at("threw") == 1);
  CHECK(plain.rates[0].successes == 2);
  CHECK(plain.rates[0].of == 4);
  CHECK(plain.rates[0].rate == 0.5);
  CHECK(plain.rates[0].interval.low == wilson_interval(2, 4)->low);
  CHECK(plain.rates[0].interval.high == wilson_interval(2, 4)->high);
  CHECK(*plain.errors[0].value == Approx(std::sqrt((9.0 + 16.0) / 2.0)));
  CHECK(plain.errors[0].n == 2);
  CHECK(plain.errors[0].of == 4);
  CHECK(*plain.over_bound.value == Approx(std::sqrt(25.0 / 5.0)));
  CHECK(*plain.values[0].value == 7.0);  // 8, 10 and 3 stems
  CHECK(plain.values[0].n == 3);
  CHECK(*plain.times[0].p50 == 2.0);
  CHECK(summary.cells[1].rates[0].successes == 3);
  CHECK(*summary.costs[0].resident_mb == 50.0);
}

TEST_CASE("worlds that differ widen the interval of a rate, equal ones leave Wilson's") {
  // Trial t is in world t mod 2: 2 of 10 right in world 0, 6 of 10 in world 1.
  std::vector<int> apart(20, 0);
  for (const std::size_t trial : {0, 2, 1, 3, 5, 7, 9, 11}) apart[trial] = 1;
  const Study study = hand_study(20, 2);
  const auto cells = summarize_study(study, hand_table(study, apart, ones_then_zeros(8, 20))).cells;
  const double widening = std::sqrt(19.0 / 6.0) * 12.706204736 / 1.959963985;
  CHECK(cells[0].rates[0].design_effect == Approx(19.0 / 6.0));
  CHECK(cells[0].rates[0].interval.low == Approx(clustered_rate_interval(8, 20, widening)->low));
  CHECK(cells[1].rates[0].design_effect < 1e-9);
  CHECK(cells[1].rates[0].interval.low == wilson_interval(8, 20)->low);
}

TEST_CASE("a point without any success has a rate, an interval, and no error") {
  const Study study = hand_study(30, 30);
  const auto none = ones_then_zeros(0, 30);
  const StudySummary summary = summarize_study(study, hand_table(study, none, none));
  const CellSummary& plain = summary.cells[0];
  CHECK(plain.rates[0].rate == 0.0);
  CHECK(plain.rates[0].interval.low == 0.0);
  CHECK(plain.rates[0].interval.high == Approx(wilson_interval(0, 30)->high));
  CHECK_FALSE(plain.errors[0].value);
  CHECK_FALSE(plain.errors[0].interval);
  CHECK_FALSE(plain.over_bound.value);
  CHECK(plain.errors[0].n == 0);
}

TEST_CASE("the bootstrap interval of an error holds it and is nothing for one trial") {
  const Study study = hand_study(200, 200);
  const auto right = ones_then_zeros(200, 200);
  const CellSummary plain = summarize_study(study, hand_table(study, right, right)).cells[0];
  REQUIRE(plain.errors[0].interval);
  CHECK(plain.errors[0].interval->low < *plain.errors[0].value);
  CHECK(plain.errors[0].interval->high > *plain.errors[0].value);
  // Errors 2, 2.2, 2.4, 2.6, 2.8 in equal parts: squares with s.d. 1.3613, RMSE 2.4166.
  const double half = 1.96 * 1.3613 / (2.0 * 2.4166) / std::sqrt(200.0);
  CHECK(0.5 * (plain.errors[0].interval->high - plain.errors[0].interval->low) ==
        Approx(half).epsilon(0.1));
  const Study one = hand_study(1, 1);
  const CellSummary single = summarize_study(one, hand_table(one, {1}, {1})).cells[0];
  CHECK(*single.errors[0].value == Approx(2.0));
  CHECK_FALSE(single.errors[0].interval);
}

TEST_CASE("how the intervals narrow, by hand") {
  const Study study = hand_study(100, 100);
  std::vector<int> half(100, 0);
  for (std::size_t k = 0; k < 100; k += 2) half[k] = 1;
  const Convergence found =
      summarize_study(study, hand_table(study, ones_then_zeros(100, 100), half)).convergence;
  REQUIRE(found.widest);
  CHECK(found.widest->method == 1);
  CHECK(found.widest->rate.half_width() == Approx(0.09617).margin(5e-6));
  // n (9.617/1)² = 9248, to two digits up.
  CHECK(found.trials_for_1 == 9300);
  CHECK(convergence_line(study, found) ==
        "±9.6 % after 100 trials, the widest interval of success (robust at sighting.noise_m = "
        "0.1); ±1 % wants about 9300 trials.");
  std::vector<std::int64_t> looks;
  for (const ConvergenceFigure& figure : found.curve) {
    if (figure.method == 0) looks.push_back(figure.trials);
  }
  CHECK(looks == std::vector<std::int64_t>{10, 15, 20, 30, 50, 70, 100});
  CHECK(found.curve.front().rate.interval.low == Approx(wilson_interval(10, 10)->low));
}

TEST_CASE("points that ended early keep their width") {
  Study study = hand_study({{"sighting.noise_m", {0.1, 0.2}, ""}}, 100, 100);
  std::vector<TrialRecord> records;
  for (std::int64_t trial = 0; trial < 100; ++trial) {
    const HandAnswer answer{trial % 2 == 0 ? 1.0 : 0.0, 0.0, 1.0, 1.0};
    if (trial < 50) records.push_back(hand_record({0, trial}, answer, answer));
    records.push_back(hand_record({1, trial}, answer, answer));
  }
  const Convergence found = summarize_study(study, study_table(study, records)).convergence;
  CHECK(found.fewest == 50);
  CHECK(found.most == 100);
  CHECK(found.widest->point == 0);
  CHECK(found.widest->rate.of == 50);
}
