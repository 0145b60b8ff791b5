#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "algo/types/random.h"
#include "eval/metrics/localization.h"

using namespace honka;
using namespace honka::eval;

using Points = std::vector<Eigen::Vector2d>;

TEST_CASE("pose errors wrap and have no sign") {
  const Pose2 truth{{1.0, 2.0}, deg_to_rad(179.0)}, estimate{{1.3, 1.6}, deg_to_rad(-179.5)};
  const PoseError error = pose_error(estimate, truth);
  CHECK(error.translation_m == Approx(0.5));
  CHECK(rad_to_deg(error.rotation_rad) == Approx(1.5));
  CHECK(pose_error(truth, estimate).rotation_rad == Approx(error.rotation_rad));
}

TEST_CASE("success needs the method's word and the truth") {
  const PoseError good{0.5, deg_to_rad(2.5)}, far{0.51, 0.0}, turned{0.0, deg_to_rad(2.51)};
  CHECK(judge(true, good).success());
  CHECK_FALSE(judge(false, good).success());
  CHECK(judge(false, good).right);
  CHECK(judge(true, far).wrong_pose());
  CHECK(judge(true, turned).wrong_pose());
  CHECK_FALSE(judge(false, far).wrong_pose());
}

TEST_CASE("the bound of a ring of stems is σ√(2/N), its heading σ/(r√N)") {
  Points ring;
  for (int k = 0; k < 12; ++k) {
    ring.emplace_back(20.0 * std::cos(kPi * k / 6.0), 20.0 * std::sin(kPi * k / 6.0));
  }
  const auto bound = cramer_rao_bound(ring, 0.1);
  REQUIRE(bound);
  CHECK(bound->translation_m == Approx(*simple_bound_m(0.1, 12)));
  CHECK(bound->rotation_rad == Approx(0.1 / (20.0 * std::sqrt(12.0))));
}

TEST_CASE("a one-sided view adds its lever arm") {
  // Two stems at (10, ±1): Σ|q − q̄|² = 2 m², so var θ = σ²/2, and at the sensor
  // var y = σ²/2 + 10² σ²/2, var x = σ²/2.
  const auto bound = cramer_rao_bound(Points{{10.0, 1.0}, {10.0, -1.0}}, 0.1);
  REQUIRE(bound);
  CHECK(bound->rotation_rad == Approx(0.1 / std::sqrt(2.0)));
  CHECK(bound->covariance(0, 0) == Approx(0.005));
  CHECK(bound->covariance(1, 1) == Approx(0.505));
  CHECK(bound->translation_m == Approx(std::sqrt(0.51)));
}

TEST_CASE("the bound is what least squares reaches") {
  RandomStream random(3, "bound");
  Points stems;
  for (int k = 0; k < 30; ++k) {
    const double range = random.uniform(5.0, 40.0), bearing = random.uniform(-1.8, 1.8);
    stems.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  const double sigma = 0.05;
  const auto bound = cramer_rao_bound(stems, sigma);
  REQUIRE(bound);
  double square_sum = 0.0;
  const int trials = 4000;
  for (int trial = 0; trial < trials; ++trial) {
    // Linear least squares about the truth, the noise being small: δ = (Σ JᵀJ)⁻¹ Σ Jᵀ e.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& q : stems) {
      const Eigen::Vector2d e(random.normal(0.0, sigma), random.normal(0.0, sigma));
      Eigen::Matrix<double, 2, 3> jacobian;
      jacobian << 1.0, 0.0, -q.y(), 0.0, 1.0, q.x();
      normal += jacobian.transpose() * jacobian;
      right += jacobian.transpose() * e;
    }
    square_sum += (normal.inverse() * right).head<2>().squaredNorm();
  }
  CHECK(std::sqrt(square_sum / trials) == Approx(bound->translation_m).epsilon(0.03));
}

TEST_CASE("too few stems bound nothing") {
  CHECK_FALSE(cramer_rao_bound({}, 0.1));
  CHECK_FALSE(cramer_rao_bound(Points{{3.0, 4.0}}, 0.1));
  CHECK_FALSE(cramer_rao_bound(Points{{3.0, 4.0}, {3.0, 4.0}}, 0.1));
  CHECK_FALSE(simple_bound_m(0.1, 0));
}
