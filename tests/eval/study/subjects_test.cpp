// Laws that every kind of trial obeys, and what each answers where nothing can be found.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "eval/study/subject.h"
#include "tests/eval/study/small_studies.h"

using namespace honka;
using namespace honka::eval;

namespace {

std::vector<std::string> kinds_of_trials() {
  std::vector<std::string> names;
  for (const StudyKind& kind : study_kinds()) names.push_back(kind.experiment);
  return names;
}

const StudyKind& kind_of_trial(const std::string& experiment) {
  for (const StudyKind& kind : study_kinds()) {
    if (kind.experiment == experiment) return kind;
  }
  throw std::runtime_error("no such kind");
}

/// The bits of everything but times, so that missing numbers are equal.
std::vector<std::uint64_t> bits_of(const StudyKind& kind, const std::vector<MethodResult>& trial) {
  std::vector<std::uint64_t> bits;
  for (const MethodResult& result : trial) {
    for (std::size_t k = 0; k < result.values.size(); ++k) {
      if (kind.measures[k].kind == MeasureKind::kTime) continue;
      const double value = result.values[k];
      bits.push_back(std::isnan(value) ? 0 : std::bit_cast<std::uint64_t>(value));
    }
  }
  return bits;
}

/// A measure of a method by its name.
double value_of(const StudyKind& kind, const MethodResult& result, const std::string& name) {
  for (std::size_t k = 0; k < kind.measures.size(); ++k) {
    if (kind.measures[k].name == name) return result.values[k];
  }
  throw std::runtime_error("no measure " + name);
}

std::vector<MethodResult> run_one(const std::string& experiment, std::int64_t trial,
                                  const std::vector<std::string>& overrides = {}) {
  return kind_of_trial(experiment).make(test::small_study(experiment, overrides))->run(trial);
}

}  // namespace

TEST_CASE("a trial of any kind gives the same digits alone, in order and in reverse") {
  const auto experiment = GENERATE(from_range(kinds_of_trials()));
  CAPTURE(experiment);
  const StudyKind& kind = kind_of_trial(experiment);
  const Scenario scenario = test::small_study(experiment);
  std::vector<std::vector<std::uint64_t>> forward, backward(4);
  const auto one = kind.make(scenario);
  for (std::int64_t trial = 0; trial < 4; ++trial) {
    forward.push_back(bits_of(kind, one->run(trial)));
  }
  const auto other = kind.make(scenario);
  for (std::size_t i = 4; i-- > 0;) {
    backward[i] = bits_of(kind, other->run(static_cast<std::int64_t>(i)));
  }
  CHECK(forward == backward);
  CHECK(bits_of(kind, kind.make(scenario)->run(3)) == forward[3]);
  CHECK(forward[0] != forward[1]);
}

TEST_CASE("a trial of any kind has one result a method and one value a measure") {
  const auto experiment = GENERATE(from_range(kinds_of_trials()));
  CAPTURE(experiment);
  const StudyKind& kind = kind_of_trial(experiment);
  const Scenario scenario = test::small_study(experiment);
  const auto methods = kind.methods(scenario);
  REQUIRE(methods.size() == 2);
  REQUIRE(kind.measures.front().kind == MeasureKind::kRate);
  const auto results = kind.make(scenario)->run(0);
  REQUIRE(results.size() == methods.size());
  for (std::size_t m = 0; m < results.size(); ++m) {
    CHECK(results[m].method == methods[m]);
    REQUIRE(results[m].values.size() == kind.measures.size());
    for (std::size_t k = 0; k < kind.measures.size(); ++k) {
      CAPTURE(kind.measures[k].name);
      const double value = results[m].values[k];
      if (kind.measures[k].kind == MeasureKind::kRate) CHECK((value == 0.0 || value == 1.0));
      if (kind.measures[k].kind == MeasureKind::kTime) CHECK(value >= 0.0);
    }
  }
}

TEST_CASE("where nothing can be found a trial answers that, with no error to tell") {
  const std::vector<std::pair<std::string, std::string>> hopeless = {
      {"sighting", "sighting.missed_share=1.0"},
      {"sighting", "sighting.map.missed_share=1.0"},
      {"localization", "frame.max_range_m=4.0"},
      {"localization", "map.inventory.missed_share=1.0"},
      {"link", "link.loss=1.0"},
  };
  const auto [experiment, key] = GENERATE_COPY(from_range(hopeless));
  CAPTURE(experiment, key);
  const StudyKind& kind = kind_of_trial(experiment);
  for (const MethodResult& result : run_one(experiment, 0, {key})) {
    CHECK(result.values.front() == 0.0);
    for (std::size_t k = 0; k < kind.measures.size(); ++k) {
      if (kind.measures[k].kind == MeasureKind::kError && kind.measures[k].name != "stem_rmse_m") {
        CHECK(std::isnan(result.values[k]));
      }
    }
    if (experiment != "link") CHECK(value_of(kind, result, "refused") == 1.0);
  }
}

TEST_CASE("a share of each kind's harmless trials succeeds") {
  for (const std::string experiment : {"sighting", "localization"}) {
    CAPTURE(experiment);
    const auto subject = kind_of_trial(experiment).make(test::small_study(experiment));
    double successes = 0.0;
    for (std::int64_t trial = 0; trial < 6; trial += 2) {
      for (const MethodResult& result : subject->run(trial)) successes += result.values.front();
    }
    CHECK(successes >= 3.0);
  }
  for (const MethodResult& result : run_one("link", 0)) CHECK(result.values.front() == 1.0);
}

TEST_CASE("a link that loses more loses the same frames and others") {
  const StudyKind& kind = kind_of_trial("link");
  double arrived_before = 2.0;
  for (const char* loss : {"link.loss=0.0", "link.loss=0.3", "link.loss=0.6"}) {
    const auto results = run_one("link", 0, {loss});
    const double arrived = value_of(kind, results.front(), "arrived");
    CHECK(arrived < arrived_before);
    CHECK(arrived == value_of(kind, results.back(), "arrived"));
    arrived_before = arrived;
  }
  CHECK(arrived_before > 0.0);
}

TEST_CASE("a noise key leaves the stems of a list and moves their error alone") {
  const StudyKind& kind = kind_of_trial("sighting");
  const auto quiet = run_one("sighting", 1),
             loud = run_one("sighting", 1, {"sighting.noise_m=0.04"});
  CHECK(value_of(kind, quiet[1], "stems") == value_of(kind, loud[1], "stems"));
  REQUIRE(quiet[1].values.front() == 1.0);
  REQUIRE(loud[1].values.front() == 1.0);
  // The same draws, twice as large.
  CHECK(value_of(kind, loud[1], "bound_m") == Approx(2.0 * value_of(kind, quiet[1], "bound_m")));
  CHECK(value_of(kind, loud[1], "translation_error_m") ==
        Approx(2.0 * value_of(kind, quiet[1], "translation_error_m")).epsilon(0.2));
}
