// Li2020 Eqs. (3) and (4).
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/li2020/covariance.h"
#include "algo/localize/li2020/selection.h"
#include "algo/localize/li2020/star_pose.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

using Six = std::array<Eigen::Vector2d, 6>;

Six random_six(std::uint64_t seed) {
  RandomStream stream(seed, "star_pose_test");
  Six points;
  for (Eigen::Vector2d& p : points) {
    p.x() = stream.uniform(-10.0, 10.0);
    p.y() = stream.uniform(-10.0, 10.0);
  }
  return points;
}

Six moved(const Pose2& T, const Six& points, double noise_m = 0.0) {
  RandomStream stream(1, "star_pose_noise");
  Six result;
  for (std::size_t i = 0; i < 6; ++i) {
    result[i] = T * points[i];
    result[i].x() += stream.normal(0.0, noise_m);
    result[i].y() += stream.normal(0.0, noise_m);
  }
  return result;
}

PoseCandidate candidate(std::uint64_t seed, const Pose2& T, double noise_m) {
  PoseCandidate c{random_six(seed), moved(T, random_six(seed), noise_m), {}};
  const StarPose pose = star_pose(c.local_m, c.map_m);
  c.T_map_local = {pose.translation_m, pose.theta_rad};
  return c;
}

}  // namespace

TEST_CASE("Li2020 Eq. (3) recovers a rigid motion") {
  const double yaw = GENERATE(0.0, 1e-9, 1.0, -2.5, kPi / 2, kPi);
  const double x = GENERATE(0.0, 500.0);
  const Pose2 T{{x, -40.0}, yaw};
  const Six local = random_six(4);
  const StarPose pose = star_pose(local, moved(T, local));
  CHECK(std::abs(wrap_to_pi(pose.theta_rad - yaw)) < 2e-8);  // arccos near 1
  CHECK((pose.translation_m - T.translation_m).norm() < 1e-6);
  CHECK(pose.cost_m < 1e-5);
}

TEST_CASE("p_t as printed is the difference of means, not the translation") {
  const Six local = random_six(9);
  const Pose2 T{{3.0, 4.0}, 1.2};
  const StarPose pose = star_pose(local, moved(T, local));
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : local) mean += p / 6.0;
  CHECK((pose.printed_translation_m - (T * mean - mean)).norm() < 1e-9);
  CHECK((pose.printed_translation_m - pose.translation_m).norm() > 0.1);
}

TEST_CASE("theta is the angle of one of the six pairs, and none fits better") {
  const Six local = random_six(5);
  const Six map = moved({{1.0, 2.0}, 0.4}, local, 0.3);
  const StarPose pose = star_pose(local, map);
  Eigen::Vector2d local_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d map_mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < 6; ++i) {
    local_mean += local[i] / 6.0;
    map_mean += map[i] / 6.0;
  }
  bool among = false;
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector2d a = local[i] - local_mean;
    const Eigen::Vector2d b = map[i] - map_mean;
    const double beta = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    among = among || std::abs(beta - pose.theta_rad) < 1e-9;
    double cost = 0.0;
    for (std::size_t j = 0; j < 6; ++j) {
      cost += (Eigen::Rotation2Dd(beta) * (local[j] - local_mean) - (map[j] - map_mean)).norm();
    }
    CHECK(pose.cost_m <= cost + 1e-9);
  }
  CHECK(among);
}

TEST_CASE("an angle of exactly 180° and a vertex in the mean give numbers") {
  Six local = random_six(6);
  Six opposite;
  for (std::size_t i = 0; i < 6; ++i) opposite[i] = -local[i];
  CHECK(std::abs(star_pose(local, opposite).theta_rad) == Approx(kPi));
  for (Eigen::Vector2d& p : local) p = Eigen::Vector2d(2, 3);
  CHECK(star_pose(local, local).theta_rad == 0.0);
  CHECK(star_pose(local, local).cost_m == 0.0);
}

TEST_CASE("a cosine that rounding puts beyond one gives an angle") {
  RandomStream stream(1, "clip_test");
  for (int i = 0; i < 200; ++i) {
    const double x = stream.uniform(-20.0, 20.0);
    const Eigen::Vector2d a(x, stream.uniform(-20.0, 20.0));
    const Six local = {a, -a, a, -a, a, -a};  // one cosine for all six, 1 up to its last digit
    const StarPose pose = star_pose(local, local);
    CHECK(std::abs(pose.theta_rad) < 1e-7);
    CHECK(pose.cost_m < 1e-4);
  }
}

TEST_CASE("Li2020 Eq. (4) takes the candidate of least sum over all vertices") {
  const Pose2 T{{10.0, 5.0}, 0.7};
  std::vector<PoseCandidate> candidates;
  candidates.push_back(candidate(1, {{-30.0, 8.0}, -2.0}, 0.0));  // a false match
  for (std::uint64_t s = 2; s < 8; ++s) candidates.push_back(candidate(s, T, 0.05));
  const Selection selection = select_candidate(candidates);
  CHECK(selection.chosen != 0);
  CHECK((selection.T_map_local.translation_m - T.translation_m).norm() < 0.2);
  double sum = 0.0;
  for (const auto& c : candidates) sum += 6.0 * mean_residual_m(c, selection.T_map_local);
  CHECK(selection.cost_m == Approx(sum));
  for (const auto& c : candidates) {
    double other = 0.0;
    for (const auto& d : candidates) other += 6.0 * mean_residual_m(d, c.T_map_local);
    CHECK(selection.cost_m <= other + 1e-9);
  }
}

TEST_CASE("the box costs no more than the best candidate and stays inside") {
  const double yaw = GENERATE(0.3, kPi, -kPi + 1e-3);
  const Pose2 T{{10.0, 5.0}, yaw};
  std::vector<PoseCandidate> candidates;
  for (std::uint64_t s = 2; s < 9; ++s) candidates.push_back(candidate(s, T, 0.2));
  const Selection discrete = select_candidate(candidates);
  const Selection box = select_in_box(candidates);
  CHECK(box.cost_m < discrete.cost_m);
  double low = INFINITY;
  double high = -INFINITY;
  double widest = 0.0;
  for (const auto& c : candidates) {
    low = std::min(low, c.T_map_local.translation_m.x());
    high = std::max(high, c.T_map_local.translation_m.x());
    widest = std::max(widest, std::abs(wrap_to_pi(c.T_map_local.yaw_rad - yaw)));
  }
  CHECK(box.T_map_local.translation_m.x() >= low);
  CHECK(box.T_map_local.translation_m.x() <= high);
  CHECK(std::abs(wrap_to_pi(box.T_map_local.yaw_rad - yaw)) <= widest + 1e-12);
}

TEST_CASE("the box binds across ±180°") {
  std::vector<PoseCandidate> candidates;
  for (std::uint64_t s = 1; s < 4; ++s) {
    const Pose2 truth{{0.0, 0.0}, -kPi + 0.2};
    candidates.push_back({random_six(s), moved(truth, random_six(s)), {}});
  }
  candidates[0].T_map_local.yaw_rad = kPi - 0.01;
  candidates[1].T_map_local.yaw_rad = kPi;
  candidates[2].T_map_local.yaw_rad = -kPi + 0.02;
  const Selection box = select_in_box(candidates);
  CHECK(box.chosen == 2);
  CHECK(box.T_map_local.yaw_rad == Approx(-kPi + 0.02));
}

TEST_CASE("residuals of a candidate") {
  PoseCandidate c;
  c.local_m.fill({0, 0});
  c.map_m.fill({0, 0});
  c.map_m[5] = {3, 4};
  CHECK(mean_residual_m(c, Pose2{}) == Approx(5.0 / 6.0));
  CHECK(largest_residual_m(c, Pose2{}) == Approx(5.0));
}

namespace {

/// Six stems on a circle about a place, as one match under a pose.
PoseCandidate ring(const Eigen::Vector2d& middle_m, const Pose2& T_map_local) {
  PoseCandidate c;
  for (std::size_t j = 0; j < 6; ++j) {
    const double angle = kPi / 3.0 * static_cast<double>(j);
    c.local_m[j] = middle_m + 5.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    c.map_m[j] = T_map_local * c.local_m[j];
  }
  c.T_map_local = T_map_local;
  return c;
}

}  // namespace

TEST_CASE("li2020: a ring of six stems states the covariance that stands on paper") {
  const Pose2 T_map_local{{40.0, -7.0}, kPi / 2.0};
  PoseCandidate c = ring({20.0, 0.0}, T_map_local);
  // A noise of 0.3 m on each axis, as residuals show it: 6 pairs of 0.3 √2 m, 9 equations too many.
  for (std::size_t j = 0; j < 6; ++j) c.map_m[j] += Eigen::Vector2d(j % 2 == 0 ? 0.3 : -0.3, 0.3);
  const double variance = 6.0 * 2.0 * 0.09 / 9.0;
  const Eigen::Matrix3d P = pose_covariance({c}, c, T_map_local, {0.0, 0.0}).value();
  // The sensor looks along the map's y; its stems are 20 m ahead and hold the yaw over 5 m.
  const double yaw = variance / (6.0 * 25.0);
  CHECK(P(2, 2) == Approx(yaw));
  CHECK(P(1, 1) == Approx(variance / 6.0));
  CHECK(P(0, 0) == Approx(variance / 6.0 + 400.0 * yaw));
  CHECK(std::abs(P(0, 2)) == Approx(20.0 * yaw));
  CHECK(P == P.transpose());
  // Twice as many matches that say the same: the noise is better known, the pose is not.
  CHECK(pose_covariance({c, c}, c, T_map_local, {0.0, 0.0})->coeff(2, 2) ==
        Approx(yaw * 2.0 * 9.0 / 21.0));
}

TEST_CASE("li2020: pairs that fit exactly, and stems on one spot, state no covariance") {
  const Pose2 T_map_local{{3.0, 2.0}, 0.5};
  const PoseCandidate exact = ring({10.0, 3.0}, {});
  CHECK_FALSE(pose_covariance({exact}, exact, {}, {0.0, 0.0}));
  PoseCandidate spot = ring({10.0, 3.0}, T_map_local);
  spot.local_m.fill({10.0, 3.0});
  CHECK_FALSE(pose_covariance({spot}, spot, T_map_local, {0.0, 0.0}));
}
