#include <catch2/catch.hpp>

#include "algo/slam/view_cone.h"
#include "algo/types/random.h"
#include "tests/support/slam_case.h"

using namespace honka;

TEST_CASE("A view cone holds what is in its opening and range") {
  const ViewCone cone;
  CHECK(cone.holds({34.9, 0.0}));
  CHECK_FALSE(cone.holds({35.1, 0.0}));
  CHECK(
      cone.holds(10.0 * Eigen::Vector2d(std::cos(deg_to_rad(104.0)), std::sin(deg_to_rad(104.0)))));
  CHECK_FALSE(cone.holds(
      10.0 * Eigen::Vector2d(std::cos(deg_to_rad(-106.0)), std::sin(deg_to_rad(-106.0)))));
  CHECK_FALSE(cone.holds({std::nan(""), 0.0}));
  CHECK(ViewCone{35.0, 360.0}.holds({-10.0, 0.0}));
}

TEST_CASE("Overlaps known on paper") {
  const ViewCone cone;
  CHECK(view_overlap(Pose2{}, cone) == 1.0);
  CHECK(view_overlap(Pose2{{70.1, 0.0}, 0.0}, cone) == 0.0);
  // Turned by 150° two openings of 210° share 60° on one side, and none is left on the other.
  CHECK(view_overlap(Pose2{{0.0, 0.0}, deg_to_rad(150.0)}, cone, 100000) ==
        Approx(60.0 / 210.0).margin(1e-3));
  // Turned round they share two sectors of 30°.
  CHECK(view_overlap(Pose2{{0.0, 0.0}, kPi}, cone, 100000) == Approx(60.0 / 210.0).margin(1e-3));
  // Two whole discs at the distance of their radius: 2/3 − √3/(2π).
  const ViewCone disc{10.0, 360.0};
  CHECK(view_overlap(Pose2{{10.0, 0.0}, 0.4}, disc, 100000) ==
        Approx(2.0 / 3.0 - std::sqrt(3.0) / (2.0 * kPi)).margin(1e-3));
}

TEST_CASE("The overlap is the same seen from both sides, within its samples") {
  RandomStream random(5, "overlap_pairs");
  const ViewOverlap overlap(ViewCone{});
  for (int k = 0; k < 200; ++k) {
    const Pose2 pose{{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)},
                     random.uniform(-kPi, kPi)};
    CHECK(overlap(pose) == Approx(overlap(pose.inverse())).margin(0.05));
  }
}

TEST_CASE("The nearest planar motion keeps a planar one and ignores tilt to first order") {
  const Pose3 level = pose_from_rpy({1.0, 2.0, 3.0}, 0.0, 0.0, 2.5);
  CHECK(nearest_planar(level).yaw_rad == Approx(2.5));
  CHECK(nearest_planar(level).translation_m == Eigen::Vector2d(1.0, 2.0));
  const Pose3 tilted = level * pose_from_rpy({0.0, 0.0, 0.0}, 0.01, -0.01, 0.0);
  CHECK(nearest_planar(tilted).yaw_rad == Approx(2.5).margin(1e-3));
}

TEST_CASE("Overlaps equal the reference pairs sample for sample") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM cases are not there");
    return;
  }
  const auto pairs = test::read_number_rows(*folder / "case0_pairs.csv");
  const auto truth = test::read_pose_rows(*folder / "case0_true_pose.csv");
  const auto chain = test::read_pose_rows(*folder / "case0_chain_pose.csv");
  REQUIRE(pairs.size() == 200);
  for (const auto& pair : pairs) {
    const auto i = static_cast<std::size_t>(pair[0]), j = static_cast<std::size_t>(pair[1]);
    CHECK(view_overlap(Pose3(truth[j].inverse() * truth[i]), ViewCone{}) == pair[2]);
    CHECK(view_overlap(Pose3(chain[j].inverse() * chain[i]), ViewCone{}) == pair[8]);
    if (i % 10 == 0) {
      CHECK(view_overlap(Pose3(truth[j].inverse() * truth[i]), ViewCone{}, 400000) ==
            Approx(pair[3]).margin(1e-4));
    }
  }
}
