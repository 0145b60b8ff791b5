#include <catch2/catch.hpp>

#include "algo/slam/convergence.h"
#include "tests/algo/slam/core_world.h"
#include "tests/support/slam_case.h"

using namespace honka;

namespace {

/// A hexagonal lattice with neighbours at the given distance.
test::StemPoints hexagonal_lattice(int count, double spacing_m) {
  test::StemPoints points;
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      points.emplace_back(spacing_m * (column + 0.5 * (row % 2)),
                          spacing_m * row * std::sqrt(3.0) / 2.0, 0.1 * row);
    }
  }
  return points;
}

}  // namespace

TEST_CASE("In a hexagonal lattice L0 is the distance of neighbours, its rim left out") {
  const test::StemPoints lattice = hexagonal_lattice(14, 3.5);
  CHECK(mean_neighbour_distance_m(lattice) == Approx(3.5));
  CHECK(mean_neighbour_distance_m(lattice, Periphery::kCounted) > 3.55);
}

TEST_CASE("L0 of clouds that are all rim, of lines and of nothing") {
  const test::StemPoints triangle = {{0, 0, 0}, {3, 0, 5}, {0, 4, 0}};
  CHECK(mean_neighbour_distance_m(triangle) == Approx(4.0));
  CHECK(mean_neighbour_distance_m(test::StemPoints{}) == 0.0);
  CHECK(mean_neighbour_distance_m(test::StemPoints{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}) == 0.0);
  test::StemPoints with_nan = triangle;
  with_nan.emplace_back(std::nan(""), 0.0, 0.0);
  CHECK(mean_neighbour_distance_m(with_nan) == Approx(4.0));
}

TEST_CASE("L0 of the reference stand") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM cases are not there");
    return;
  }
  test::StemPoints stems;
  for (const auto& row : test::read_number_rows(*folder / "case0_stems_world.csv")) {
    stems.emplace_back(row[0], row[1], row[2]);
  }
  CHECK(mean_neighbour_distance_m(stems) == Approx(3.678743843121189).epsilon(1e-5));
  CHECK(mean_neighbour_distance_m(stems, Periphery::kCounted) ==
        Approx(4.007074539314932).epsilon(1e-5));
}

TEST_CASE("The limits with the paper's numbers, and the slip in its 3.7 degrees") {
  const ConvergenceLimits limits = convergence_limits(3.5, 0.6, 35.0);
  CHECK(limits.translation_m == Approx(1.75));
  CHECK(rad_to_deg(limits.rotation_rad) == Approx(4.53).margin(0.005));
  CHECK(rad_to_deg(1.75 / (std::sqrt(0.6) * 35.0)) == Approx(3.7).margin(0.005));
  CHECK(rad_to_deg(limits.tilt_rad) == Approx(8.2));
}

TEST_CASE("Turn and tilt take a rotation apart") {
  const Eigen::Vector2d turned = turn_and_tilt(pose_from_rpy({0, 0, 0}, 0.0, 0.2, -1.2).linear());
  CHECK(turned.x() == Approx(1.2));
  CHECK(turned.y() == Approx(0.2));
  CHECK(turn_and_tilt(pose_from_rpy({0, 0, 0}, 0.3, 0.0, 0.0).linear()).y() == Approx(0.3));
}

TEST_CASE("The ellipsoid passes through its half axes") {
  const ConvergenceLimits limits = convergence_limits(3.5, 0.6, 35.0);
  const double d = limits.translation_m, t = limits.rotation_rad, f = limits.tilt_rad;
  CHECK(convergence_measure(Pose3::Identity(), limits) == 0.0);
  CHECK(convergence_measure(Pose3(Eigen::Translation3d(0.0, d, 0.0)), limits) == Approx(1.0));
  CHECK(convergence_measure(pose_from_rpy({0, 0, 0}, 0.0, 0.0, -t), limits) == Approx(1.0));
  CHECK(convergence_measure(pose_from_rpy({0, 0, 0}, f, 0.0, 0.0), limits) == Approx(1.0));
  CHECK(convergence_measure(pose_from_rpy({d / 2, 0, 0}, 0.0, 0.0, t / 2), limits) == Approx(0.5));
}
