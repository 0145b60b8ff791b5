#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/pose.h"

using namespace honka;

TEST_CASE("degrees and radians") {
  CHECK(deg_to_rad(180.0) == Approx(kPi));
  CHECK(rad_to_deg(deg_to_rad(37.5)) == Approx(37.5));
}

TEST_CASE("wrap_to_pi: the same direction beyond −π, up to π") {
  CHECK(wrap_to_pi(0.0) == 0.0);
  CHECK(wrap_to_pi(kPi) == Approx(kPi));
  CHECK(wrap_to_pi(-kPi) == Approx(kPi));
  CHECK(wrap_to_pi(3.0 * kPi) == Approx(kPi));
  for (double angle = -50.0; angle < 50.0; angle += 0.37) {
    const double wrapped = wrap_to_pi(angle);
    CHECK(wrapped > -kPi);
    CHECK(wrapped <= kPi);
    CHECK(std::cos(wrapped) == Approx(std::cos(angle)).margin(1e-12));
    CHECK(std::sin(wrapped) == Approx(std::sin(angle)).margin(1e-12));
  }
}

TEST_CASE("Pose2: a quarter turn, then a step") {
  const Pose2 T_a_b{{1.0, 2.0}, kPi / 2};
  CHECK((T_a_b * Eigen::Vector2d(3.0, 0.0) - Eigen::Vector2d(1.0, 5.0)).norm() < 1e-12);
}

TEST_CASE("Pose2: laws of a group") {
  const double yaw = GENERATE(0.0, 1e-9, 2.0, kPi, -3.1);
  const Pose2 T_a_b{{4.0, -1.0}, yaw};
  const Pose2 T_b_c{{-2.0, 0.5}, 1.3};
  const Pose2 T_c_d{{100.0, 7.0}, -2.4};
  const Eigen::Vector2d p(0.3, 8.0);

  const Pose2 identity = T_a_b * T_a_b.inverse();
  CHECK(identity.translation_m.norm() < 1e-12);
  CHECK(std::abs(identity.yaw_rad) < 1e-12);
  CHECK(((T_a_b * T_b_c) * p - T_a_b * (T_b_c * p)).norm() < 1e-12);
  const Pose2 left = (T_a_b * T_b_c) * T_c_d;
  const Pose2 right = T_a_b * (T_b_c * T_c_d);
  CHECK((left.translation_m - right.translation_m).norm() < 1e-9);
  CHECK(std::abs(wrap_to_pi(left.yaw_rad - right.yaw_rad)) < 1e-12);
}

TEST_CASE("roll, pitch, yaw: x ahead, y left, z up") {
  const Pose3 T = pose_from_rpy({1, 2, 3}, 0.0, 0.0, kPi / 2);
  CHECK((T * Eigen::Vector3d::UnitX() - Eigen::Vector3d(1, 3, 3)).norm() < 1e-12);
  // Positive pitch lowers the nose, positive roll lowers the right side.
  CHECK((pose_from_rpy({0, 0, 0}, 0.0, 0.1, 0.0) * Eigen::Vector3d::UnitX()).z() < 0.0);
  CHECK((pose_from_rpy({0, 0, 0}, 0.1, 0.0, 0.0) * -Eigen::Vector3d::UnitY()).z() < 0.0);
}

TEST_CASE("the planar part of a tilted pose keeps position and yaw") {
  const Pose3 T = pose_from_rpy({5, 6, 7}, 0.02, -0.03, 2.1);
  CHECK(yaw_of(T) == Approx(2.1));
  CHECK(planar(T).translation_m == Eigen::Vector2d(5, 6));
  CHECK(planar(T).yaw_rad == Approx(2.1));
}
