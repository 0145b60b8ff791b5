#include <catch2/catch.hpp>

#include "eval/metrics/trajectory_errors.h"
#include "tests/eval/metrics/synthetic_poses.h"

using namespace honka;
using namespace honka::eval;
using honka::test::noisy;
using honka::test::winding;

namespace {

using Motions = std::vector<Motion>;

RelativeSettings over(double delta, DeltaUnit unit, bool all_pairs = false) {
  return {delta, unit, all_pairs};
}

/// Estimates at these times and places on the x axis.
PosePairs along_x(const std::vector<double>& times_s, const std::vector<double>& x_m) {
  PosePairs pairs;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const Pose3 pose = pose_from_rpy({x_m[i], 0, 0}, 0, 0, 0);
    pairs.poses.push_back({times_s[i], pose, pose});
  }
  return pairs;
}

const std::vector<RelativeSettings> kAllSettings = {
    over(1.0, DeltaUnit::kSeconds), over(5.0, DeltaUnit::kMetres),
    over(5.0, DeltaUnit::kMetres, true), over(3.0, DeltaUnit::kFrames),
    over(3.0, DeltaUnit::kFrames, true)};

void check_same(const std::vector<double>& a, const std::vector<double>& b, double margin) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).margin(margin));
}

}  // namespace

TEST_CASE("statistics of trajectory errors, with n below the root") {
  const auto s = trajectory_statistics(std::vector<double>{1.0, 2.0, 3.0, 6.0});
  REQUIRE(s);
  CHECK(s->mean == 3.0);
  CHECK(s->median == 2.5);
  CHECK(s->sse == 50.0);
  CHECK(s->rmse == Approx(std::sqrt(12.5)));
  CHECK(s->std == Approx(std::sqrt(3.5)));
  CHECK(s->min == 1.0);
  CHECK(s->max == 6.0);
  CHECK_FALSE(trajectory_statistics({}));
  CHECK(trajectory_statistics(std::vector<double>{4.0})->std == 0.0);
}

TEST_CASE("absolute errors are the distance and the angle put in") {
  PosePairs pairs = winding(20);
  const Pose3 offset = pose_from_rpy({0.3, 0.0, 0.4}, 0.0, deg_to_rad(3.0), 0.0);
  for (PosePair& pair : pairs.poses) pair.estimate = pair.truth * offset;
  const TrajectoryErrors errors = absolute_errors(pairs);
  check_same(errors.translation_m, std::vector<double>(20, 0.5), 1e-12);
  check_same(errors.rotation_deg, std::vector<double>(20, 3.0), 1e-9);
  // A half turn is 180 degrees, not less and no NaN.
  pairs.poses[0].estimate = pairs.poses[0].truth * pose_from_rpy({0, 0, 0}, 0, 0, kPi);
  CHECK(absolute_errors(pairs).rotation_deg[0] == Approx(180.0));
  pairs.truth_has_rotations = false;
  CHECK(absolute_errors(pairs).rotation_deg.empty());
  check_same({absolute_errors(pairs).translation_m[1]}, {0.5}, 1e-12);
}

TEST_CASE("motions over time begin in every pose, the last and the unpaired are no end") {
  PosePairs pairs = along_x({0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5});
  CHECK(motions(pairs, over(2, DeltaUnit::kSeconds)) == Motions{{0, 2}, {1, 3}, {2, 4}});
  CHECK(motions(pairs, over(2, DeltaUnit::kSeconds, true)) == Motions{{0, 2}, {1, 3}, {2, 4}});
  CHECK(motions(pairs, over(1.5, DeltaUnit::kSeconds)) == Motions{{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  CHECK(motions(pairs, over(0.3, DeltaUnit::kSeconds)).empty());
  CHECK(motions(pairs, over(5, DeltaUnit::kSeconds)).empty());
  // The estimate goes on to 6 s and has a pose at 2.9 s, neither with truth.
  pairs.estimate_times_s = {0, 1, 2, 2.9, 3, 4, 5, 6};
  CHECK(motions(pairs, over(2, DeltaUnit::kSeconds)) == Motions{{0, 2}, {1, 3}, {2, 4}, {3, 5}});
  CHECK(motions(pairs, over(1.92, DeltaUnit::kSeconds)) == Motions{{0, 2}, {2, 4}, {3, 5}});
}

TEST_CASE("motions over metres follow the estimate's path") {
  PosePairs pairs = along_x({0, 1, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4, 5, 6});
  CHECK(motions(pairs, over(2, DeltaUnit::kMetres)) == Motions{{2, 4}, {4, 6}});
  CHECK(motions(pairs, over(1.5, DeltaUnit::kMetres)) == Motions{{2, 4}, {4, 6}});
  CHECK(motions(pairs, over(2, DeltaUnit::kMetres, true)) ==
        Motions{{0, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}});
  CHECK(motions(pairs, over(2.15, DeltaUnit::kMetres, true)).size() == 5);
  CHECK(motions(pairs, over(1.5, DeltaUnit::kMetres, true)).empty());
  CHECK(motions(pairs, over(10, DeltaUnit::kMetres)).empty());
  // Of those equally near the first.
  CHECK(motions(along_x({0, 1, 2, 3}, {0, 0.95, 0.95, 1.5}), over(1, DeltaUnit::kMetres, true)) ==
        Motions{{0, 1}});
  // There and back is path, although it leads nowhere; standing still is none.
  pairs = along_x({0, 1, 2, 3, 4, 5}, {0, 1, 1, 0, 0, 1});
  CHECK(motions(pairs, over(1, DeltaUnit::kMetres)) == Motions{{1, 3}, {3, 5}});
  CHECK(motions(pairs, over(1, DeltaUnit::kMetres, true)) ==
        Motions{{0, 1}, {1, 3}, {2, 3}, {3, 5}, {4, 5}});
}

TEST_CASE("ten steps of a decimetre are a metre, wherever they begin") {
  Motions expected;
  for (std::size_t i = 10; i < 100; i += 10) expected.push_back({i, i + 10});
  for (const double start_m : {0.0, 3.3, 1000.7, 674321.1}) {
    std::vector<double> x_m, times_s;
    for (int i = 0; i <= 100; ++i) times_s.push_back(x_m.emplace_back(start_m + 0.1 * i));
    CHECK(motions(along_x(times_s, x_m), over(1, DeltaUnit::kMetres)) == expected);
  }
}

TEST_CASE("motions over frames") {
  const PosePairs pairs = winding(7);
  CHECK(motions(pairs, over(2, DeltaUnit::kFrames)) == Motions{{0, 2}, {2, 4}, {4, 6}});
  CHECK(motions(pairs, over(4, DeltaUnit::kFrames)) == Motions{{0, 4}});
  CHECK(motions(pairs, over(5, DeltaUnit::kFrames, true)) == Motions{{0, 5}, {1, 6}});
  CHECK(motions(pairs, over(7, DeltaUnit::kFrames)).empty());
  CHECK(motions({}, over(1, DeltaUnit::kFrames)).empty());
  CHECK(motions({}, over(1, DeltaUnit::kSeconds)).empty());
  CHECK(motions({}, over(1, DeltaUnit::kMetres, true)).empty());
}

TEST_CASE("a steady drift is the relative error of every motion") {
  PosePairs pairs;
  for (int i = 0; i < 50; ++i) {
    pairs.poses.push_back({0.1 * i, pose_from_rpy({1.0 * i, 0, 0}, 0, 0, 0),
                           pose_from_rpy({1.02 * i, 0, 0}, 0.001 * i, 0, 0)});
  }
  const auto errors = relative_errors(pairs, motions(pairs, over(5, DeltaUnit::kFrames, true)));
  check_same(errors.translation_m, std::vector<double>(45, 0.1), 1e-12);
  check_same(errors.rotation_deg, std::vector<double>(45, rad_to_deg(0.005)), 1e-9);
  pairs.estimate_has_rotations = false;
  const auto bare = relative_errors(pairs, motions(pairs, over(5, DeltaUnit::kFrames, true)));
  check_same(bare.translation_m, std::vector<double>(45, 0.1), 1e-12);
  CHECK(bare.rotation_deg.empty());
  for (PosePair& pair : pairs.poses) std::swap(pair.truth, pair.estimate);
  check_same(
      relative_errors(pairs, motions(pairs, over(5, DeltaUnit::kFrames, true))).translation_m,
      std::vector<double>(45, 0.1), 1e-12);
}

TEST_CASE("relative errors do not know where either trajectory lies") {
  const PosePairs pairs = noisy(100, 0.05, 0.01);
  PosePairs elsewhere = moved(pairs, {1.0, pose_from_rpy({100, -50, 20}, 1.0, -0.5, 2.0)});
  for (PosePair& pair : elsewhere.poses) {
    pair.truth = pose_from_rpy({-3, 8, 1}, 0.2, 0.3, -2.0) * pair.truth;
  }
  for (const RelativeSettings& settings : kAllSettings) {
    for (const bool rotations : {true, false}) {
      PosePairs a = pairs, b = elsewhere;
      a.truth_has_rotations = b.truth_has_rotations = rotations;
      const Motions here = motions(a, settings);
      REQUIRE(here.size() > 5);
      CHECK(here == motions(b, settings));
      check_same(relative_errors(a, here).translation_m, relative_errors(b, here).translation_m,
                 1e-9);
      check_same(relative_errors(a, here).rotation_deg, relative_errors(b, here).rotation_deg,
                 1e-6);
    }
  }
}

TEST_CASE("a perfect estimate has no relative error") {
  const PosePairs pairs = winding(100);
  for (const RelativeSettings& settings : kAllSettings) {
    const auto errors = relative_errors(pairs, motions(pairs, settings));
    REQUIRE(!errors.translation_m.empty());
    CHECK(trajectory_statistics(errors.translation_m)->max < 1e-12);
    CHECK(trajectory_statistics(errors.rotation_deg)->max < 1e-5);
  }
}
