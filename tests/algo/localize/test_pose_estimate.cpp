// The pose of an accepted place: unknown partners, honest covariance, radial bias.
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/consensus/partners.h"
#include "tests/algo/localize/consensus_world.h"

using namespace honka;
using namespace honka::test;

namespace {

/// Information of x, y, yaw at the sensor, and of a radial bias, from stems of noise 1 m.
Eigen::Matrix4d pose_and_bias_information(const Stems& stems_in_local) {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  for (const Eigen::Vector2d& q : stems_in_local) {
    Eigen::Matrix<double, 2, 4> moved;
    moved << 1.0, 0.0, -q.y(), q.x() / q.norm(), 0.0, 1.0, q.x(), q.y() / q.norm();
    information += moved.transpose() * moved;
  }
  return information;
}

/// Squared error of the position over its bound with a bias unknown, and without; how often a bias
/// was taken out, and its squared error.
struct BiasTrial {
  double error_m2 = 0.0, bound_m2 = 0.0, bound_unbiased_m2 = 0.0, bias_error_m2 = 0.0;
  int taken_out = 0;
  [[nodiscard]] double over_bound() const { return std::sqrt(error_m2 / bound_m2); }
};

BiasTrial try_bias(const SightingSettings& kind, double radial_bias_sds, std::uint64_t lists) {
  const Stems map = honka::test::forest(900, 21);
  ConsensusSettings settings;
  settings.radial_bias_sds = radial_bias_sds;
  const ConsensusMatcher matcher(std::make_shared<ConsensusIndex>(map), settings);
  BiasTrial trial;
  for (std::uint64_t k = 0; k < lists; ++k) {
    const Sighting seen = sight(map, kind, k);
    const auto answer = matcher.locate(seen.stems);
    REQUIRE(answer.accepted());
    const Eigen::Matrix4d information = pose_and_bias_information(seen.stems);
    const Eigen::Matrix4d with_bias = information.inverse();
    const Eigen::Matrix3d without = information.topLeftCorner<3, 3>().inverse();
    const double variance = kind.noise_m * kind.noise_m;
    trial.error_m2 += std::pow(shift_between(answer.T_map_local, seen.T_map_local), 2);
    trial.bound_m2 += variance * with_bias.topLeftCorner<2, 2>().trace();
    trial.bound_unbiased_m2 += variance * without.topLeftCorner<2, 2>().trace();
    trial.bias_error_m2 += std::pow(answer.radial_bias_m - kind.radial_bias_m, 2);
    trial.taken_out += answer.radial_bias_m != 0.0 ? 1 : 0;
  }
  return trial;
}

}  // namespace

TEST_CASE("consensus: partners of a graph without loops are those of counting all cases") {
  // Local 0 may be map 0 or 1, local 1 may be map 1: cases 1, a, b, c, a c (b c would share map 1)
  const double a = 2.0;
  const double b = 5.0;
  const double c = 3.0;
  std::vector<PossiblePair> pairs{{0, 0, a, 0.0}, {0, 1, b, 0.0}, {1, 1, c, 0.0}};
  share_partners(pairs, 2);
  const double all = 1.0 + a + b + c + a * c;
  CHECK(pairs[0].probability == Approx((a + a * c) / all).epsilon(1e-12));
  CHECK(pairs[1].probability == Approx(b / all).epsilon(1e-12));
  CHECK(pairs[2].probability == Approx((c + a * c) / all).epsilon(1e-12));
}

TEST_CASE("consensus: two stems cannot share a partner, and huge odds give numbers") {
  std::vector<PossiblePair> pairs{{0, 0, 1e250, 0.0}, {1, 0, 1e3, 0.0}, {1, 1, 4.0, 0.0}};
  share_partners(pairs, 2);
  CHECK(pairs[0].probability == Approx(1.0));
  CHECK(pairs[1].probability < 1e-6);
  CHECK(pairs[2].probability == Approx(0.8).epsilon(1e-6));
  std::vector<PossiblePair> none;
  share_partners(none, 0);
  CHECK(none.empty());
}

TEST_CASE("consensus: a radial bias without noise is found to the digits, and the pose with it") {
  const Stems map = honka::test::forest(900, 20);
  for (const double bias_m : {-0.05, 0.08, 0.2}) {
    SightingSettings kind;
    kind.radial_bias_m = bias_m;
    const Sighting seen = sight(map, kind, 3);
    const auto answer = consensus_of(map).locate(seen.stems);
    REQUIRE(answer.accepted());
    CHECK(answer.radial_bias_m == Approx(bias_m).margin(1e-6));
    CHECK(shift_between(answer.T_map_local, seen.T_map_local) < 1e-6);
  }
}

TEST_CASE("consensus: with a radial bias the error is at the bound that an unknown bias leaves") {
  SightingSettings kind{0.05, 0.1, 0.0};
  kind.radial_bias_m = 0.08;
  const BiasTrial corrected = try_bias(kind, ConsensusSettings{}.radial_bias_sds, 100);
  CHECK(corrected.taken_out == 100);
  CHECK(corrected.over_bound() == Approx(1.0).margin(0.15));  // 100 lists: 5 % is one s.d.
  CHECK(std::sqrt(corrected.bias_error_m2 / 100.0) < 0.02);
  const BiasTrial left_in = try_bias(kind, 1e9, 100);
  CHECK(left_in.taken_out == 0);
  CHECK(left_in.over_bound() > 2.0);
}

TEST_CASE("consensus: without a bias next to none is taken out, and the error is at the bound") {
  const SightingSettings kind{0.1, 0.1, 0.0};
  const BiasTrial tested = try_bias(kind, ConsensusSettings{}.radial_bias_sds, 200);
  CHECK(tested.taken_out <= 4);  // 0.3 % of them by chance
  const BiasTrial never = try_bias(kind, 1e9, 200);
  CHECK(std::sqrt(tested.error_m2 / never.error_m2) < 1.02);
  CHECK(std::sqrt(never.error_m2 / never.bound_unbiased_m2) == Approx(1.0).margin(0.1));
  // Always: the price of an unknown that is not there
  const BiasTrial always = try_bias(kind, 0.0, 200);
  CHECK(always.taken_out == 200);
  CHECK(always.over_bound() == Approx(1.0).margin(0.1));
  CHECK(always.error_m2 > never.error_m2);
}

TEST_CASE("consensus: at half a metre of noise the covariance knows that partners are unknown") {
  const Stems map = honka::test::forest(900, 22);
  const ConsensusMatcher matcher = consensus_of(map);
  double squares = 0.0;
  int accepted = 0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Sighting seen = sight(map, {0.5, 0.0, 0.2}, k);
    const auto answer = matcher.locate(seen.stems);
    if (!answer.accepted()) continue;
    Eigen::Vector3d error;
    error << answer.T_map_local.translation_m - seen.T_map_local.translation_m,
        wrap_to_pi(answer.T_map_local.yaw_rad - seen.T_map_local.yaw_rad);
    squares += error.dot(answer.covariance->inverse() * error);
    ++accepted;
  }
  CHECK(accepted > 85);
  // Mean 3 where honest, s.d. 0.25 at 100 lists; pairs taken as given make it 4.6
  CHECK(squares / accepted == Approx(3.0).margin(0.8));
}
