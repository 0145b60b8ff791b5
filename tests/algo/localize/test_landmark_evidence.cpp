// What views say of a stem: it stands, it never stood, it was felled between them.
#include <catch2/catch.hpp>

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

bool is_gone(const LandmarkEvidence& evidence, const std::string& views) {
  return !evidence.stands(viewed(views), 100.0);
}

bool joins(const LandmarkEvidence& evidence, const std::string& views) {
  MapLandmark landmark = viewed(views);
  landmark.in_map = false;
  return evidence.stands(landmark, 100.0);
}

}  // namespace

TEST_CASE("one view weighs what paper says") {
  // Of a rate of 0.8 forty-nine stems in fifty are seen, half as often the fiftieth: 0.792.
  const LandmarkEvidence evidence(even_rates(0.8), 0.05);
  CHECK(evidence.stands_over_never(viewed("x")) == Approx(0.792 / 0.05));
  CHECK(evidence.stands_over_never(viewed(".")) == Approx(0.208 / 0.95));
  CHECK(evidence.stands_over_never(viewed("")) == Approx(1.0));
  CHECK(evidence.stands_over_never(viewed(std::string(5000, 'x'))) <= 1e30);
  CHECK(evidence.stands_over_never(viewed(std::string(5000, '.'))) >= 0.0);
  // After one miss 0.95 / 0.208 = 4.6 to one, and a little for what was felled before it.
  CHECK(evidence.stands(viewed("."), 4.8));
  CHECK_FALSE(evidence.stands(viewed("."), 4.55));
}

TEST_CASE("without a view all stays as it is") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  CHECK_FALSE(is_gone(evidence, ""));
  CHECK_FALSE(joins(evidence, ""));
}

TEST_CASE("a stem that was seen for long is soon gone, and soon back") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  for (const std::size_t seen : {0U, 5U, 60U, 5000U}) {
    CAPTURE(seen);
    const std::string before(seen, 'x');
    CHECK_FALSE(is_gone(evidence, before + "."));
    CHECK(is_gone(evidence, before + "........"));
    CHECK_FALSE(is_gone(evidence, before + "........xxxxxx"));
    // One false match does not bring it back.
    CHECK(is_gone(evidence, before + "........x.."));
  }
}

TEST_CASE("a stem joins when it is seen again and again, and leaves when it is felled") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  CHECK_FALSE(joins(evidence, "x"));
  CHECK(joins(evidence, "xxx"));
  CHECK(joins(evidence, "xxxxxx."));
  CHECK_FALSE(joins(evidence, "xxxxxx........"));
  // Something every tenth time is what false stems come to.
  CHECK_FALSE(joins(evidence, "x.........x.........x........."));
}

TEST_CASE("a stem that undergrowth hides from three views in four stands") {
  const LandmarkEvidence evidence(even_rates(0.9), 0.03);
  std::string text;
  for (int k = 0; k < 10; ++k) text += "x...";
  CHECK(evidence.stands_over_never(viewed(text)) > 100.0);
  CHECK_FALSE(is_gone(evidence, text));
}

TEST_CASE("of stems that stand less than one in the decision's ratio is taken for gone") {
  for (const double rate : {0.5, 0.8, 0.95}) {
    const LandmarkEvidence evidence(even_rates(rate), 0.03);
    int gone = 0;
    for (const MapLandmark& stem : random_stems(3000, 40, rate, 1.0)) {
      gone += evidence.stands(stem, 100.0) ? 0 : 1;
    }
    CAPTURE(rate);
    CHECK(gone <= 30);
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
