#include <catch2/catch.hpp>

#include "algo/geometry/se3.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

Twist random_twist(std::uint64_t seed, double size) {
  RandomStream random(seed, "twist");
  Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = random.uniform(-1.0, 1.0);
  return size * twist;
}

}  // namespace

TEST_CASE("log undoes exp for zero, tiny, usual and large motions") {
  for (const double size : {0.0, 1e-12, 1e-8, 1e-5, 9e-5, 2e-4, 1e-3, 0.1, 1.0, 1.7}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Twist twist = random_twist(seed, size);
      if (twist.tail<3>().norm() >= kPi - 0.01) continue;
      CHECK((se3_log(se3_exp(twist)) - twist).norm() < 1e-13 + 1e-12 * size);
      const Pose3 pose = se3_exp(twist);
      const Eigen::Matrix3d unit = pose.linear().transpose() * pose.linear();
      CHECK((unit - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    }
  }
}

TEST_CASE("known rotations and screws") {
  CHECK((so3_exp({0.0, 0.0, kPi / 2.0}) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY())
            .norm() < 1e-15);
  const Eigen::Vector3d half_turn = so3_log(so3_exp({kPi, 0.0, 0.0}));
  CHECK(half_turn.cwiseAbs().x() == Approx(kPi));
  // A quarter of a circle of radius 1 to the left: arc π/2 ahead while turning π/2.
  Twist quarter = Twist::Zero();
  quarter[0] = kPi / 2.0;
  quarter[5] = kPi / 2.0;
  CHECK((se3_exp(quarter).translation() - Eigen::Vector3d(1.0, 1.0, 0.0)).norm() < 1e-15);
}

TEST_CASE("interpolation meets its ends and halves its way") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Pose3 start = se3_exp(random_twist(seed, 1.0));
    const Pose3 end = start * se3_exp(random_twist(seed + 50, 0.8));
    CHECK(interpolate(start, end, 0.0).isApprox(start, 1e-12));
    CHECK(interpolate(start, end, 1.0).isApprox(end, 1e-12));
    const Pose3 half = interpolate(start, end, 0.5);
    CHECK((start.inverse() * half).isApprox(half.inverse() * end, 1e-12));
  }
}
