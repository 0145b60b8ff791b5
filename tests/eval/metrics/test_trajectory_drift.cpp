#include <catch2/catch.hpp>
#include <cmath>

#include "eval/metrics/trajectory_drift.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// A straight drive along x, a pose every half metre, 30 m; `estimate` makes the estimated pose.
template <class Estimate>
PosePairs straight(const Estimate& estimate) {
  PosePairs pairs;
  for (int i = 0; i <= 60; ++i) {
    const double x = 0.5 * i;
    pairs.poses.push_back({x, pose_from_rpy({x, 0, 0}, 0, 0, 0), estimate(x)});
  }
  return pairs;
}

std::vector<double> way_of(const PosePairs& pairs) {
  std::vector<double> way;
  for (const PosePair& pair : pairs.poses) way.push_back(pair.truth.translation().x());
  return way;
}

}  // namespace

TEST_CASE("a scale error of 2 % is a drift of 2 % over every length") {
  const PosePairs pairs = straight([](double x) {
    return pose_from_rpy({1.02 * x, 0, 0}, 0, 0, 0);
  });
  const auto errors = sub_path_errors(pairs, way_of(pairs));
  // Starts at 0 … 20 m for 10 m, at 0 … 10 m for 20 m; 50 and 100 m are longer than the drive.
  CHECK(mean_drift(errors, 10.0)->sub_paths == 21);
  CHECK(mean_drift(errors, 20.0)->sub_paths == 11);
  CHECK_FALSE(mean_drift(errors, 50.0));
  CHECK(mean_drift(errors)->sub_paths == 32);
  CHECK(mean_drift(errors)->percent == Approx(2.0));
  CHECK(mean_drift(errors)->deg_per_m == Approx(0.0).margin(1e-9));
  CHECK(errors[1].start_s == 1.0);
  CHECK(errors[0].translation_m == Approx(0.2));
}

TEST_CASE("a constant turn of the estimate drifts as its chord does") {
  // Heading κ s along an arc of curvature κ: over L metres the turn is κ L, and the end of the arc,
  // seen from its start, lies at (sin κL, 1 − cos κL) / κ where the truth has (L, 0).
  constexpr double kappa = 0.001;
  const PosePairs pairs = straight([](double x) {
    return pose_from_rpy({std::sin(kappa * x) / kappa, (1 - std::cos(kappa * x)) / kappa, 0}, 0, 0,
                         kappa * x);
  });
  const auto drift = mean_drift(sub_path_errors(pairs, way_of(pairs), {{20.0}, 1.0}));
  const double x = std::sin(0.02) / kappa - 20.0, y = (1 - std::cos(0.02)) / kappa;
  REQUIRE(drift);
  CHECK(drift->percent == Approx(100.0 * std::hypot(x, y) / 20.0));
  CHECK(drift->deg_per_m == Approx(rad_to_deg(kappa)));
}

TEST_CASE("time at rest makes no sub-paths, and a turned world no drift") {
  PosePairs pairs = straight([](double x) {
    return pose_from_rpy({5, 3, 1}, 0, 0, 1.0) * pose_from_rpy({x, 0, 0}, 0, 0, 0);
  });
  std::vector<double> way = way_of(pairs);
  const auto moving = sub_path_errors(pairs, way);
  for (int i = 0; i < 100; ++i) {
    PosePair rest = pairs.poses.back();
    rest.time_s += 0.1;
    pairs.poses.push_back(rest);
    way.push_back(way.back());
  }
  const auto errors = sub_path_errors(pairs, way);
  CHECK(errors.size() == moving.size());
  CHECK(mean_drift(errors)->percent == Approx(0.0).margin(1e-9));
}

TEST_CASE("no pose, no drift") {
  CHECK(sub_path_errors({}, {}).empty());
  CHECK_FALSE(mean_drift({}));
}
