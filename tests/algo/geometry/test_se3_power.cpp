// Powers of rigid transforms: laws over all sizes of rotation, and long-double references.
#include <catch2/catch.hpp>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/geometry/se3_power.h"
#include "algo/types/random.h"
#include "tests/support/slam_case.h"

using namespace honka;

namespace {

const std::vector<double> kPowerAngles = {0.0, 1e-12, 1e-9, 1e-6,       1e-4,      1e-2,
                                          0.5, 1.5,   3.0,  kPi - 1e-3, kPi - 1e-6};

Eigen::Vector3d power_axis(RandomStream& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// A transform that turns by the angle about a random axis and moves by up to 10 m an axis.
Pose3 turned_pose(double angle_rad, std::uint64_t id) {
  RandomStream random(3, "turned_pose", {id});
  Pose3 pose = Pose3::Identity();
  pose.linear() = Eigen::AngleAxisd(angle_rad, power_axis(random)).toRotationMatrix();
  for (int k = 0; k < 3; ++k) pose.translation()[k] = random.uniform(-10.0, 10.0);
  return pose;
}

double pose_gap(const Pose3& a, const Pose3& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("Powers agree with the long-double references") {
  const auto file = std::filesystem::path(HONKA_SOURCE_DIR) / "tests" / "data" / "slam_cases" /
                    "se3_power_reference.csv";
  const auto rows = test::read_number_rows(file);
  const auto bases = test::read_pose_rows(file, 5);
  const auto powers = test::read_pose_rows(file, 17);
  REQUIRE(rows.size() == 278);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    INFO("row " << k << ": angle " << rows[k][0] << ", u " << rows[k][1]);
    CHECK(pose_gap(pose_power(bases[k], rows[k][1]), powers[k]) < 1e-12);
  }
}

TEST_CASE("A power at 0, 1 and -1 is the identity, the transform and its inverse") {
  for (const double angle : kPowerAngles) {
    for (std::uint64_t id = 0; id < 10; ++id) {
      const Pose3 pose = turned_pose(angle, id);
      const PosePower power(pose);
      INFO("angle " << angle);
      CHECK(pose_gap(power(0.0), Pose3::Identity()) == 0.0);
      CHECK(pose_gap(power(1.0), pose) < 1e-13);
      CHECK(pose_gap(power(-1.0), pose.inverse()) < 1e-13);
    }
  }
}

TEST_CASE("Powers add up, also beyond a turn") {
  for (const double angle : kPowerAngles) {
    for (const auto& [a, b] : std::vector<std::pair<double, double>>{
             {0.3, 0.7}, {-0.4, 1.7}, {1e-9, 0.5}, {17.0, -12.5}, {250.0, 31.0}}) {
      const PosePower power(turned_pose(angle, 40));
      INFO("angle " << angle << ", powers " << a << " and " << b);
      const double size = 1.0 + std::abs(a) + std::abs(b);
      CHECK(pose_gap(power(a) * power(b), power(a + b)) < 1e-13 * size);
    }
  }
}

TEST_CASE("The inverse power undoes the power") {
  for (const double angle : kPowerAngles) {
    for (const double u : {1e-3, 0.1, 1.0 / 3.0, 0.5, 0.9, 1.0}) {
      const Pose3 pose = turned_pose(angle, 50);
      INFO("angle " << angle << ", u " << u);
      CHECK(pose_gap(pose_power(pose_power(pose, u), 1.0 / u), pose) < 1e-13 / u);
    }
  }
}

TEST_CASE("A power is exp of the scaled logarithm, and a pure translation scales") {
  for (const double angle : {1e-3, 0.5, 1.5, 3.0}) {
    for (const double u : {-1.0, 0.25, 0.8, 1.0}) {
      const Pose3 pose = turned_pose(angle, 60);
      CHECK(pose_gap(pose_power(pose, u), se3_exp(u * se3_log(pose))) < 1e-11);
    }
  }
  Pose3 shift = Pose3::Identity();
  shift.translation() << 3.0, -4.0, 0.5;
  CHECK(pose_gap(pose_power(shift, -2.5), Pose3(Eigen::Translation3d(-7.5, 10.0, -1.25))) == 0.0);
}

TEST_CASE("A quarter circle in thirds lies on its circle") {
  // Turning left by 90 degrees about (0, 1): the scanner drives from (0, 0) to (1, 1).
  const Pose3 quarter = pose_from_rpy({1.0, 1.0, 0.0}, 0.0, 0.0, kPi / 2.0);
  const Pose3 third = pose_power(quarter, 1.0 / 3.0);
  CHECK(third.translation().x() == Approx(std::sin(kPi / 6.0)));
  CHECK(third.translation().y() == Approx(1.0 - std::cos(kPi / 6.0)));
  CHECK(yaw_of(third) == Approx(kPi / 6.0));
}

TEST_CASE("Turn and distance of a power grow with u") {
  for (const double angle : kPowerAngles) {
    const PosePower power(turned_pose(angle, 70));
    double distance_m = 0.0, turn_rad = 0.0;
    for (double u = 0.01; u <= 1.0; u += 0.01) {
      const Pose3 part = power(u);
      INFO("angle " << angle << ", u " << u);
      CHECK(part.translation().norm() >= distance_m);
      CHECK(PosePower(part).angle_rad() >= turn_rad - 1e-14);
      distance_m = part.translation().norm();
      turn_rad = PosePower(part).angle_rad();
    }
  }
}

TEST_CASE("A correction does not contract the motions it is put on, contrary to the paper") {
  // §2.2 claims that t_lj Δτ^u turns and moves no more than t_lj. Over random paths with random
  // corrections about half of the frames turn and move less, the others more.
  int frames = 0, less = 0;
  for (std::uint64_t id = 0; id < 200; ++id) {
    const PosePower path(turned_pose(1.0, 100 + id));
    RandomStream random(3, "correction_size", {id});
    Pose3 correction = pose_power(turned_pose(0.1, 400 + id), 0.1);
    const PosePower correct(correction);
    for (double u = 0.1; u < 0.95; u += 0.1) {
      const Pose3 before = path(u), after = before * correct(u);
      ++frames;
      if (PosePower(after).angle_rad() <= PosePower(before).angle_rad() &&
          after.translation().norm() <= before.translation().norm()) {
        ++less;
      }
    }
  }
  CHECK(less > 0.1 * frames);
  CHECK(less < 0.6 * frames);
}

TEST_CASE("Powers stay rigid and finite at a half turn and for huge u") {
  for (const double angle : {kPi, 1e-300, 1e-160}) {
    for (const double u : {0.5, -3.0, 1e6}) {
      const Pose3 power = pose_power(turned_pose(angle, 90), u);
      INFO("angle " << angle << ", u " << u);
      REQUIRE(power.matrix().allFinite());
      const Eigen::Matrix3d unit = power.linear().transpose() * power.linear();
      CHECK((unit - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    }
  }
}
