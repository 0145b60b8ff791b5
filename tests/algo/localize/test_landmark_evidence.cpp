// What views say of a stem: it stands, it never stood, it is gone since one of them.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/landmark_evidence.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

RangeRates even_rates(double rate) {
  RangeRates rates;
  rates.fill(rate);
  return rates;
}

/// Views that saw the stem where the text has an x.
MapLandmark viewed(const std::string& text) {
  MapLandmark landmark;
  landmark.in_map = true;
  for (const char c : text) landmark.views.push_back({{0.0, 0.0}, 2, c == 'x'});
  return landmark;
}

/// Lists of stems that stand or do not, each in view `views` times.
std::vector<MapLandmark> random_stems(std::uint64_t count, std::uint64_t views, double rate,
                                      double standing_share) {
  std::vector<MapLandmark> stems;
  for (std::uint64_t i = 0; i < count; ++i) {
    RandomStream random(3, "landmark_views", {i, views});
    const bool stands = random.uniform() < standing_share;
    std::string text;
    for (std::uint64_t k = 0; k < views; ++k) {
      text += random.uniform() < (stands ? rate : 0.02) ? 'x' : '.';
    }
    stems.push_back(viewed(text));
  }
  return stems;
}

const double kDecision = std::log(100.0);

}  // namespace

TEST_CASE("one view weighs what paper says") {
  // Nine in ten as visible as the rate of 0.8, one half as much: 0.76 are seen.
  const LandmarkEvidence evidence(even_rates(0.8), 0.05);
  CHECK(evidence.stands_over_never(viewed("x")) == Approx(std::log(0.76 / 0.05)));
  CHECK(evidence.stands_over_never(viewed(".")) == Approx(std::log(0.24 / 0.95)));
  CHECK(evidence.gone_over_stands(viewed(".")) == Approx(std::log(0.95 / 0.24)));
  // Gone before it was seen, or never there: what was seen was none.
  CHECK(evidence.gone_over_stands(viewed("x")) == Approx(std::log(0.05 / 0.76)));
  CHECK(evidence.stands_over_never(viewed("")) == Approx(0.0).margin(1e-12));
  CHECK(evidence.gone_over_stands(viewed("")) == 0.0);
}

TEST_CASE("a stem that stood for long is as soon gone as one that was never seen") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  for (const std::size_t seen : {0U, 5U, 60U, 500U}) {
    CAPTURE(seen);
    const std::string before(seen, 'x');
    CHECK(evidence.gone_over_stands(viewed(before + "..")) < kDecision);
    CHECK(evidence.gone_over_stands(viewed(before + "............")) > kDecision);
    CHECK(evidence.gone_over_stands(viewed(before + "............xxx")) < kDecision);
  }
  CHECK(evidence.stands_over_never(viewed(std::string(60, 'x') + "............")) > kDecision);
}

TEST_CASE("a stem that undergrowth hides from three views in four stands") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  std::string text;
  for (int k = 0; k < 10; ++k) text += "...x";
  CHECK(evidence.gone_over_stands(viewed(text)) < kDecision);
  CHECK(evidence.stands_over_never(viewed(text)) > kDecision);
  // Something every twentieth time is what false stems come to.
  CHECK(evidence.stands_over_never(viewed("x..................." + std::string(20, '.'))) < 0.0);
}

TEST_CASE("of stems that stand at most one in the decision's ratio is taken for gone") {
  for (const double rate : {0.5, 0.8, 0.95}) {
    const LandmarkEvidence evidence(even_rates(rate), 0.03);
    int gone = 0;
    for (const MapLandmark& stem : random_stems(3000, 40, rate, 1.0)) {
      gone += evidence.gone_over_stands(stem) > kDecision ? 1 : 0;
    }
    CAPTURE(rate);
    // Whenever it is asked (Ville 1939): the views, read backwards, are a likelihood ratio, and
    // nine tenths of it are the ratio of stems of this visibility.
    CHECK(gone <= 3000 / 100 / 0.9 + 10);
  }
}

TEST_CASE("rates come out right where each stem was in view twice, and half are felled") {
  for (const double rate : {0.5, 0.9}) {
    const RangeRates rates = detection_rates(random_stems(4000, 2, rate, 0.5), 0.03);
    CAPTURE(rate);
    CHECK(rates[2] == Approx(rate).margin(0.12));
    CHECK(rates[0] == Approx(0.5).margin(1e-9));  // nothing was in view there
  }
  const RangeRates many = detection_rates(random_stems(2000, 30, 0.7, 0.4), 0.03);
  CHECK(many[2] == Approx(0.7).margin(0.02));
  for (const double rate : detection_rates({}, 0.03)) CHECK(rate == Approx(0.5));
}
