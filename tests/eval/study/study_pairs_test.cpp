#include "eval/study/study_pairs.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/eval/study/hand_study.h"

using namespace honka::eval;
using honka::test::failed_record;
using honka::test::hand_record;
using honka::test::hand_study;
using honka::test::hand_table;
using honka::test::HandAnswer;

namespace {

std::vector<PairedFigure> compared(const Study& study, const Table& trials) {
  StudyDraws draws;
  return compare_methods(study, trials, study_cells(study, trials), draws);
}

/// Success of both methods: so many trials with both, plain alone, robust alone, none.
Table counted_table(const Study& study, int both, int plain, int robust, int none) {
  std::vector<int> first, second;
  const auto add = [&](int times, int a, int b) {
    first.insert(first.end(), static_cast<std::size_t>(times), a);
    second.insert(second.end(), static_cast<std::size_t>(times), b);
  };
  add(both, 1, 1);
  add(plain, 1, 0);
  add(robust, 0, 1);
  add(none, 0, 0);
  return hand_table(study, first, second);
}

}  // namespace

TEST_CASE("methods on the same trials: the published interval, seen from the second") {
  // Newcombe 1998, table II, method 10: 36, 12, 2, 0 → [0.0569, 0.3404], first − second.
  const Study study = hand_study(50, 50);
  const auto pairs = compared(study, counted_table(study, 36, 2, 12, 0));
  const PairedFigure& rate = pairs.front();
  CHECK(*rate.first_value == Approx(38.0 / 50.0));
  CHECK(*rate.second_value == Approx(48.0 / 50.0));
  CHECK(*rate.difference == Approx(0.2));
  CHECK(rate.interval->low == Approx(0.0569).margin(5e-5));
  CHECK(rate.interval->high == Approx(0.3404).margin(5e-5));
  // 2 (1 + 14 + 91) / 2^14
  CHECK(*rate.mcnemar == Approx(212.0 / 16384.0));
  CHECK(rate.better == 1u);
  CHECK(verdict_of(study, rate) ==
        "robust succeeds more often than plain: +20.0 % [+5.7, +34.0], n 50");
}

TEST_CASE("the verdict takes the side of the better method, and of none without a difference") {
  const Study study = hand_study(50, 50);
  const auto other = compared(study, counted_table(study, 36, 12, 2, 0)).front();
  CHECK(other.better == 0u);
  CHECK(verdict_of(study, other) ==
        "plain succeeds more often than robust: +20.0 % [+5.7, +34.0], n 50");
  const auto same = compared(study, counted_table(study, 40, 4, 5, 1)).front();
  CHECK_FALSE(same.better);
  CHECK(verdict_of(study, same).find("no difference seen between plain and robust: +2.0 % [") == 0);
  const auto never = compared(study, counted_table(study, 50, 0, 0, 0)).front();
  CHECK_FALSE(never.better);
  CHECK(*never.mcnemar == 1.0);
  CHECK(never.interval->low < 0.0);
}

TEST_CASE("errors are compared over the trials that both methods have") {
  // hand_table(): plain errs twice as much as robust in every trial.
  const Study study = hand_study(50, 50);
  const auto pairs = compared(study, counted_table(study, 36, 2, 12, 0));
  REQUIRE(pairs.size() == 2);  // success and the error; the bound is no error of a method
  const PairedFigure& error = pairs[1];
  CHECK(error.n == 36);
  CHECK(error.of == 50);
  CHECK(*error.first_value == Approx(2.0 * *error.second_value));
  CHECK(*error.difference == Approx(-*error.second_value));
  CHECK(error.better == 1u);
  CHECK(error.interval->high < 0.0);
  CHECK(verdict_of(study, error).find("robust errs less in translation_error_m than plain: −1.2") ==
        0);
}

TEST_CASE("failed trials stay in the comparison, all failed compare nothing but zeros") {
  const Study study = hand_study(4, 4);
  std::vector<TrialRecord> records;
  for (std::int64_t trial = 0; trial < 4; ++trial) {
    records.push_back(failed_record({0, trial}, TrialStatus::kTimedOut, "too long"));
  }
  const auto pairs = compared(study, study_table(study, records));
  CHECK(pairs[0].n == 4);
  CHECK(*pairs[0].difference == 0.0);
  CHECK_FALSE(pairs[1].difference);
  CHECK(verdict_of(study, pairs[1]) == "plain and robust: no trial has both, n 0 of 4");
}

TEST_CASE("of fewer than ten trials no difference is called seen") {
  const Study nine = hand_study(9, 9), ten = hand_study(10, 10);
  const PairedFigure few = compared(nine, counted_table(nine, 9, 0, 0, 0))[1];
  CHECK_FALSE(few.better);
  CHECK(verdict_of(nine, few).find("too few trials to tell plain and robust: −1.18") == 0);
  CHECK(compared(ten, counted_table(ten, 10, 0, 0, 0))[1].better == 1u);
}

TEST_CASE("points are compared together first, then one by one") {
  const Study study = hand_study({{"sighting.noise_m", {0.1, 0.2}, ""}}, 30, 30);
  std::vector<TrialRecord> records;
  for (std::int64_t trial = 0; trial < 30; ++trial) {
    const HandAnswer right{1.0, 0.0, 1.0, 1.0}, lost{0.0, 1.0};
    records.push_back(hand_record({0, trial}, right, right));
    records.push_back(hand_record({1, trial}, trial < 15 ? right : lost, right));
  }
  const auto pairs = compared(study, study_table(study, records));
  REQUIRE(pairs.size() == 6);
  CHECK_FALSE(pairs[0].point);
  CHECK(pairs[0].n == 60);
  CHECK_FALSE(pairs[0].mcnemar);  // both points have the same trials
  CHECK(*pairs[4].mcnemar == Approx(2.0 / 32768.0));
  CHECK(*pairs[0].difference == Approx(0.25));
  CHECK(pairs[2].point == 0);
  CHECK(*pairs[2].difference == 0.0);
  CHECK(pairs[4].point == 1);
  CHECK(*pairs[4].difference == Approx(0.5));
}
