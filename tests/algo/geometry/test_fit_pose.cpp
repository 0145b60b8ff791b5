#include <catch2/catch.hpp>
#include <vector>

#include "algo/geometry/fit_pose.h"
#include "algo/types/random.h"

using namespace honka;

TEST_CASE("A fit recovers a motion, also from mirrored and from flat pairs") {
  RandomStream random(3, "fit_pose");
  std::vector<Eigen::Vector3d> source, target;
  for (int k = 0; k < 20; ++k) {
    const double x_m = random.uniform(-15.0, 15.0);
    source.emplace_back(x_m, random.uniform(-15.0, 15.0), 0.0);
  }
  const Pose3 truth = pose_from_rpy({100.0, -50.0, 3.0}, 0.1, 0.2, -3.0);
  for (const Eigen::Vector3d& p : source) target.emplace_back(truth * p);
  CHECK((fit_pose(target, source).matrix() - truth.matrix()).norm() < 1e-11);
  for (Eigen::Vector3d& p : target) p.x() = -p.x();
  CHECK(fit_pose(target, source).linear().determinant() == Approx(1.0));
  // One place: the rotation asked for stays.
  const std::vector<Eigen::Vector3d> one(3, Eigen::Vector3d(1.0, 2.0, 3.0));
  const Pose3 shift = fit_pose(one, std::span(source).first(3), truth.linear());
  CHECK(shift.linear() == truth.linear());
}
