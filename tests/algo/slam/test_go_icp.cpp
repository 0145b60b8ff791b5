// Go-ICP: right poses, true certificates, caps, and equal digits.
#include <catch2/catch.hpp>

#include "algo/slam/registration/go_icp.h"
#include "algo/slam/registration/search_size.h"
#include "algo/slam/registration/share_test.h"
#include "algo/slam/registration/trimmed_icp.h"
#include "tests/algo/slam/registration_pairs.h"

namespace {

using namespace honka;

GoIcpSettings without_clock() {
  GoIcpSettings settings;
  settings.time_cap_s = 0.0;
  return settings;
}

/// The best objective that planar ICP reaches from the truth and from many starts.
double best_of_many_starts(const test::RegistrationPair& pair, const GoIcpSettings& settings,
                           int starts, std::uint64_t id) {
  const NearestStems target(pair.target_m);
  TrimmedIcpSettings icp;
  icp.inlier_ratio = settings.inlier_share;
  RandomStream random(5, "many_starts", {id});
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < starts; ++k) {
    Pose3 start = pair.T_target_source;
    if (k > 0) {
      start = test::disturbed(pair.guess, random.uniform(-30.0, 30.0), random.uniform(-5.0, 5.0),
                              random.uniform(-5.0, 5.0));
    }
    const auto end = trimmed_icp(pair.target_m, pair.source_m, start, icp);
    // Only what lies in the region that the certificate is about.
    const Pose3 off = pair.guess.inverse() * end.T_target_source;
    if (std::abs(yaw_of(off)) > deg_to_rad(settings.search_yaw_deg)) continue;
    const Eigen::Vector3d moved = end.T_target_source.translation() - pair.guess.translation();
    if (moved.head<2>().cwiseAbs().maxCoeff() > settings.search_translation_m) continue;
    best = std::min(best, trimmed_planar_rmse(target, pair.source_m, end.T_target_source,
                                              settings.inlier_share));
  }
  return best;
}

TEST_CASE("Go-ICP finds clean views of one stand, in both modes") {
  for (const char* mode : {"certify", "l0"}) {
    for (std::uint64_t id = 0; id < 4; ++id) {
      const auto pair = test::pair_of_views(id, 0.0);
      GoIcpSettings settings = without_clock();
      settings.mode = mode;
      const auto result = go_icp(pair.target_m, pair.source_m, pair.guess, settings, ViewCone{});
      CAPTURE(mode, id);
      CHECK(result.status == RegistrationStatus::kRegistered);
      CHECK(test::planar_distance_m(result.T_target_source, pair.T_target_source) < 0.1);
      CHECK(test::yaw_difference_deg(result.T_target_source, pair.T_target_source) < 0.5);
      CHECK(result.nodes > 0);
      CHECK(result.lower_bound_m <= result.rmse_m + 1e-9);
      if (settings.mode == "certify") CHECK(result.certified);
    }
  }
}

TEST_CASE("The last fit brings roll, pitch and height") {
  auto pair = test::pair_of_views(3, 0.0);
  const Pose3 T_tilted_target = pose_from_rpy({0.0, 0.0, 0.7}, 0.03, -0.04, 0.0);
  for (auto& p : pair.target_m) p = T_tilted_target * p;
  const Pose3 truth = T_tilted_target * pair.T_target_source;
  const Pose3 upright =
      pose_from_rpy({pair.guess.translation().x(), pair.guess.translation().y(), 0.0}, 0.0, 0.0,
                    yaw_of(pair.guess));
  const auto result = go_icp(pair.target_m, pair.source_m, upright, without_clock());
  CHECK(result.status == RegistrationStatus::kRegistered);
  CHECK((result.T_target_source.translation() - truth.translation()).norm() < 0.1);
  const Eigen::Matrix3d off = result.T_target_source.linear().transpose() * truth.linear();
  CHECK(Eigen::AngleAxisd(off).angle() < deg_to_rad(0.5));

  GoIcpSettings flat = without_clock();
  flat.tilt = false;
  const auto planar_result = go_icp(pair.target_m, pair.source_m, upright, flat);
  CHECK(planar_result.T_target_source.translation().z() == 0.0);
  CHECK(planar_result.T_target_source(2, 2) == 1.0);
}

TEST_CASE("No start of ICP beats a certified objective by more than its gap", "[certificate]") {
  for (std::uint64_t id = 0; id < 6; ++id) {
    // The last two have no partners at all: the certificate holds, the share test refuses.
    auto pair = test::pair_of_views(id, 0.07);
    if (id >= 4) pair.source_m = test::pair_of_views(id + 50, 0.07).source_m;
    GoIcpSettings settings = without_clock();
    settings.tilt = false;
    settings.node_cap = 200000;
    const auto result = go_icp(pair.target_m, pair.source_m, pair.guess, settings);
    REQUIRE(result.certified);
    CHECK(result.gap_m <= settings.gap_m + 1e-12);
    CHECK(result.rmse_m - result.gap_m == Approx(result.lower_bound_m).margin(1e-9));
    const double other = best_of_many_starts(pair, settings, 60, id);
    CAPTURE(id, result.rmse_m, other);
    CHECK(other >= result.lower_bound_m - 1e-9);
    const auto expected =
        id < 4 ? RegistrationStatus::kRegistered : RegistrationStatus::kUnverified;
    CHECK(result.status == expected);
  }
}

TEST_CASE("A cap gives the best so far and says so") {
  const auto pair = test::pair_of_views(1, 0.07);
  GoIcpSettings settings = without_clock();
  settings.node_cap = 20;
  const auto capped = go_icp(pair.target_m, pair.source_m, pair.guess, settings);
  CHECK(capped.status == RegistrationStatus::kTimeCap);
  CHECK_FALSE(capped.certified);
  CHECK(capped.nodes <= 22);
  CHECK(capped.T_target_source.matrix().allFinite());

  GoIcpSettings clock = settings;
  clock.node_cap = 0;
  clock.time_cap_s = 1e-9;
  const auto late = go_icp(pair.target_m, pair.source_m, pair.guess, clock);
  CHECK(late.status == RegistrationStatus::kTimeCap);

  const auto free = go_icp(pair.target_m, pair.source_m, pair.guess, without_clock());
  CHECK(free.lower_bound_m >= capped.lower_bound_m);
  CHECK(free.rmse_m <= capped.rmse_m + 0.05);
}

TEST_CASE("Go-ICP answers with the same digits every time, and whatever lies far away") {
  auto pair = test::pair_of_views(2, 0.07);
  const auto first = go_icp(pair.target_m, pair.source_m, pair.guess, without_clock());
  const auto second = go_icp(pair.target_m, pair.source_m, pair.guess, without_clock());
  CHECK(first.T_target_source.matrix() == second.T_target_source.matrix());
  CHECK(first.nodes == second.nodes);

  // Both clouds in a map's coordinates: the region turns about the clouds, not about the map.
  const Eigen::Vector3d far(350000.0, 6700000.0, 0.0);
  Pose3 T_far_target = Pose3::Identity();
  T_far_target.translation() = far;
  for (auto& p : pair.source_m) p = T_far_target * (pair.T_target_source * p);
  for (auto& p : pair.target_m) p = T_far_target * p;
  const auto result = go_icp(pair.target_m, pair.source_m, Pose3::Identity(), without_clock());
  CHECK(result.status == RegistrationStatus::kRegistered);
  CHECK(result.rmse_m < 0.2);
  CHECK((result.T_target_source * far - far).norm() < 0.3);
}

TEST_CASE("The sizes of Table 3 come from two formulas") {
  CHECK(search_size_of_ball(1.0, 1.2) == Approx(353.4e6).epsilon(1e-3));
  CHECK(search_size_of_box(3.7, 1.75, 60.0) == Approx(1.433e6).epsilon(1e-3));
  // Neither gives the other's figure, nor the printed 1.9 m the printed 1.5e6.
  CHECK(search_size_of_box(1.0, 1.2, 180.0) > 600e6);
  CHECK(search_size_of_box(3.7, 1.9, 60.0) < 1.2e6);
}

TEST_CASE("Finer leaves are more leaves, leaves of L0 are few", "[granularity]") {
  const auto pair = test::pair_of_views(0, 0.07);
  std::int64_t before = 0;
  for (const double leaf_m : {3.0, 1.75, 0.8}) {
    GoIcpSettings settings = without_clock();
    settings.mode = "l0";
    settings.leaf_translation_m = leaf_m;
    settings.leaf_yaw_deg = 2.6 * leaf_m;
    const auto result = go_icp(pair.target_m, pair.source_m, pair.guess, settings);
    CHECK(result.nodes > before);
    before = result.nodes;
  }
}

TEST_CASE("Case 0: at least 95 % right and 90 % certified where 40 % have partners", "[case0]") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM case is absent");
    return;
  }
  GoIcpSettings settings = without_clock();
  settings.node_cap = 50000;
  int right = 0, certified = 0, wrong_but_registered = 0;
  const auto pairs = test::pairs_of_case(*folder, 60, 0.4);
  for (const auto& pair : pairs) {
    const auto result = go_icp(pair.target_m, pair.source_m, pair.guess, settings, ViewCone{});
    const bool is_right = test::is_right(result.T_target_source, pair.T_target_source);
    right += is_right ? 1 : 0;
    certified += result.certified ? 1 : 0;
    wrong_but_registered += result.usable() && !is_right ? 1 : 0;
  }
  CHECK(right >= 57);
  CHECK(certified >= 54);
  CHECK(wrong_but_registered == 0);
}

}  // namespace
