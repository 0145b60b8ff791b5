#include <catch2/catch.hpp>

#include "eval/metrics/stem_scores.h"

using namespace honka::eval;

using Points = std::vector<Eigen::Vector2d>;

TEST_CASE("nearest pairs first, one to one, within the gate") {
  const Points truth = {{0.0, 0.0}, {1.0, 0.0}, {9.0, 9.0}};
  const Points found = {{0.45, 0.0}, {0.1, 0.0}, {5.0, 5.0}};
  const auto pairs = match_stems(found, truth, 0.6);
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0].found == 0);  // its nearest, (0, 0), is taken by a nearer one
  CHECK(pairs[0].truth == 1);
  CHECK(pairs[0].distance_m == Approx(0.55));
  CHECK(pairs[1].found == 1);
  CHECK(pairs[1].truth == 0);
  CHECK(match_stems(found, truth, 0.5).size() == 1);
  CHECK(match_stems({}, truth, 0.5).empty());
  CHECK(match_stems(found, {}, 0.5).empty());
}

TEST_CASE("precision, recall and F1 by range") {
  StemSet truth, found;
  truth.positions_m = {{5.0, 0.0}, {15.0, 0.0}, {0.0, 15.0}, {25.0, 0.0}};
  found.positions_m = {{5.1, 0.0}, {15.2, 0.0}, {-8.0, 0.0}};
  const StemScores scores = score_stems(found, truth, {0.0, 0.0}, 0.5);
  CHECK(*scores.all.precision() == Approx(2.0 / 3.0));
  CHECK(*scores.all.recall() == Approx(0.5));
  CHECK(*scores.all.f1() == Approx(4.0 / 7.0));
  REQUIRE(scores.by_range.size() == 5);
  CHECK(*scores.by_range[0].detection.precision() == Approx(0.5));
  CHECK(*scores.by_range[0].detection.recall() == Approx(1.0));
  CHECK(*scores.by_range[1].detection.recall() == Approx(0.5));
  CHECK(*scores.by_range[2].detection.recall() == 0.0);
  CHECK_FALSE(scores.by_range[2].detection.precision());
  CHECK_FALSE(scores.by_range[3].detection.recall());
  CHECK_FALSE(scores.by_range[4].detection.f1());
}

TEST_CASE("position bias splits into towards and across the ray") {
  StemSet truth, found;
  truth.positions_m = {{10.0, 0.0}, {0.0, 10.0}};
  found.positions_m = {{9.9, 0.02}, {-0.02, 9.9}};  // 0.1 m near, 0.02 m counter-clockwise
  const StemScores scores = score_stems(found, truth, {0.0, 0.0}, 0.5);
  CHECK(*scores.radial_bias_m == Approx(-0.1));
  CHECK(*scores.tangential_bias_m == Approx(0.02));
  CHECK(*scores.position_rmse_m == Approx(std::sqrt(0.0104)));
}

TEST_CASE("DBH is scored where both are known, ranges may be given") {
  StemSet truth, found;
  truth.positions_m = {{10.0, 0.0}, {0.0, 10.0}, {-10.0, 0.0}};
  truth.dbh_m = {0.20, 0.30, std::nullopt};
  truth.ranges_m = {35.0, 35.0, 35.0};
  found = truth;
  found.dbh_m = {0.23, 0.29, 0.4};
  const StemScores scores = score_stems(found, truth, {0.0, 0.0}, 0.5);
  CHECK(scores.dbh_pairs == 2);
  CHECK(*scores.dbh_bias_m == Approx(0.01));
  CHECK(*scores.dbh_rmse_m == Approx(std::sqrt(0.0005)));
  CHECK(scores.by_range[3].detection.truth_matched == 3);
}

TEST_CASE("scores of nothing are nothing") {
  const StemScores scores = score_stems({}, {}, {0.0, 0.0}, 0.5);
  CHECK_FALSE(scores.all.precision());
  CHECK_FALSE(scores.all.recall());
  CHECK_FALSE(scores.all.f1());
  CHECK_FALSE(scores.position_rmse_m);
  CHECK_FALSE(scores.radial_bias_m);
  CHECK_FALSE(scores.dbh_rmse_m);
}
