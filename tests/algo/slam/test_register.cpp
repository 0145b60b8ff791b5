// Laws that every registration method keeps.
#include <catch2/catch.hpp>
#include <limits>

#include "algo/slam/registration/register.h"
#include "algo/slam/registration/share_test.h"
#include "algo/types/user_error.h"
#include "tests/algo/slam/registration_pairs.h"

namespace {

using namespace honka;
using test::StemPoints;

RegisterSettings register_settings() {
  RegisterSettings settings;
  settings.go_icp.time_cap_s = 0.0;
  settings.go_icp.node_cap = 3000;
  return settings;
}

Registration run_method(const std::string& method, const StemPoints& target,
                        const StemPoints& source, const Pose3& initial = Pose3::Identity()) {
  return register_clouds(target, source, method, register_settings(), initial);
}

/// A pose, and numbers that can be printed.
void check_is_sound(const Registration& r) {
  CHECK(r.T_target_source.matrix().allFinite());
  const Eigen::Matrix3d R = r.T_target_source.linear();
  CHECK((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  CHECK(R.determinant() > 0.0);
  for (const double x : {r.rmse_m, r.overlap, r.share, r.lower_bound_m, r.gap_m}) {
    CHECK(std::isfinite(x));
  }
  CHECK(r.share >= 0.0);
  CHECK(r.share <= 1.0);
}

TEST_CASE("Each method leaves a cloud on itself") {
  const StemPoints stems = test::random_stems(60, 50.0, 1);
  for (const std::string& method : registration_methods()) {
    CAPTURE(method);
    const auto result = run_method(method, stems, stems);
    CHECK(result.status == RegistrationStatus::kRegistered);
    CHECK((result.T_target_source.matrix() - Pose3::Identity().matrix()).norm() < 1e-6);
    CHECK(result.rmse_m < 1e-6);
    CHECK(result.share == 1.0);
    CHECK(result.inliers == 60);
    check_is_sound(result);
  }
}

TEST_CASE("Each method finds a known motion of a clean cloud from a guess nearby") {
  const StemPoints source = test::random_stems(60, 50.0, 2);
  const Pose3 truth = pose_from_rpy({4.0, -3.0, 0.5}, 0.01, 0.02, 0.5);
  const Pose3 guess = pose_from_rpy({4.3, -2.8, 0.3}, 0.0, 0.0, 0.52);
  StemPoints target;
  for (const auto& p : source) target.push_back(truth * p);
  for (const std::string& method : registration_methods()) {
    CAPTURE(method);
    const auto result = run_method(method, target, source, guess);
    CHECK(result.status == RegistrationStatus::kRegistered);
    CHECK((result.T_target_source.translation() - truth.translation()).norm() < 0.05);
    CHECK((result.T_target_source.linear() - truth.linear()).norm() < 0.005);
  }
}

TEST_CASE("A cloud that fits in two ways is laid on itself in one of them") {
  // A half turn about (2, 1) maps the cloud onto itself.
  StemPoints stems = test::random_stems(20, 30.0, 3);
  const std::size_t half = stems.size();
  for (std::size_t k = 0; k < half; ++k) {
    stems.emplace_back(4.0 - stems[k].x(), 2.0 - stems[k].y(), stems[k].z());
  }
  for (const std::string& method : registration_methods()) {
    CAPTURE(method);
    const auto result = run_method(method, stems, stems);
    CHECK(result.status == RegistrationStatus::kRegistered);
    CHECK(result.rmse_m < 1e-6);
    check_is_sound(result);
  }
}

TEST_CASE("Each method refuses too few points, lines, and numbers that are none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const StemPoints good = test::random_stems(40, 40.0, 4);
  StemPoints line, one_place, with_nan = good, with_infinity = good;
  for (int k = 0; k < 20; ++k) line.emplace_back(k, 2.0 * k, 0.0);
  for (int k = 0; k < 20; ++k) one_place.emplace_back(1.0, 1.0, 0.0);
  with_nan[7].y() = nan;
  with_infinity[7].z() = infinite;
  const std::vector<StemPoints> few = {
      {}, {good[0]}, {good[0], good[1]}, {good[0], good[1], good[1]}, line, one_place};
  const Pose3 initial = pose_from_rpy({1.0, 2.0, 3.0}, 0.0, 0.0, 0.4);
  for (const std::string& method : registration_methods()) {
    CAPTURE(method);
    const auto check = [&](const StemPoints& target, const StemPoints& source,
                           RegistrationStatus status) {
      const auto result = run_method(method, target, source, initial);
      CHECK(result.status == status);
      CHECK(result.T_target_source.matrix() == initial.matrix());
      check_is_sound(result);
    };
    for (const StemPoints& cloud : few) {
      CAPTURE(cloud.size());
      check(cloud, good, RegistrationStatus::kTooFewPoints);
      check(good, cloud, RegistrationStatus::kTooFewPoints);
    }
    for (const StemPoints& cloud : {with_nan, with_infinity}) {
      check(cloud, good, RegistrationStatus::kNotFinite);
      check(good, cloud, RegistrationStatus::kNotFinite);
    }
    Pose3 bad = initial;
    bad.translation().x() = nan;
    const auto refused = run_method(method, good, good, bad);
    CHECK(refused.status == RegistrationStatus::kNotFinite);
    check_is_sound(refused);
  }
}

TEST_CASE("Clouds that do not belong together are unverified, duplicates do no harm") {
  const StemPoints a = test::random_stems(60, 50.0, 5);
  StemPoints elsewhere = test::random_stems(60, 50.0, 6);
  StemPoints doubled = a;
  doubled.insert(doubled.end(), a.begin(), a.end());
  for (const std::string& method : registration_methods()) {
    CAPTURE(method);
    const auto wrong = run_method(method, a, elsewhere);
    CHECK_FALSE(wrong.usable());
    check_is_sound(wrong);
    for (auto& p : elsewhere) p.x() += 5000.0;
    check_is_sound(run_method(method, a, elsewhere));
    for (auto& p : elsewhere) p.x() -= 5000.0;
    CHECK(run_method(method, a, doubled).usable());
    CHECK(run_method(method, doubled, a).usable());
  }
}

TEST_CASE("Evidence grows with partners beyond chance") {
  CHECK(share_evidence(0, 0, 0.1) == 0.0);
  CHECK(share_evidence(3, 30, 0.1) == 0.0);  // what chance gives
  CHECK(share_evidence(10, 10, 0.01) == Approx(10.0 * std::log(100.0)));
  // 4 of 8 at a quarter: 8 (½ ln 2 + ½ ln ⅔)
  CHECK(share_evidence(4, 8, 0.25) == Approx(4.0 * std::log(4.0 / 3.0)));
  for (int k = 4; k < 30; ++k) CHECK(share_evidence(k + 1, 30, 0.1) > share_evidence(k, 30, 0.1));
}

TEST_CASE("The common view is the cone, or the hull with its margin") {
  const StemPoints square = {{0, 0, 0}, {10, 0, 5}, {10, 10, 0}, {0, 10, 0}, {5, 5, 0}};
  const CommonView hull(square, std::nullopt, 0.5);
  CHECK(hull.holds({5.0, 0.1}));
  CHECK(hull.holds({5.0, -0.4}));
  CHECK_FALSE(hull.holds({5.0, -0.6}));
  CHECK(hull.overlap(Pose3::Identity()) == 1.0);
  CHECK(hull.chance(0.35) == Approx(1.0 - std::exp(-0.05 * 3.14159265 * 0.1225)));
  const CommonView cone(square, ViewCone{}, 0.5);
  CHECK(cone.holds({30.0, 0.0}));
  CHECK_FALSE(cone.holds({-5.0, 0.1}));
  CHECK(cone.overlap(Pose3::Identity()) == 1.0);
}

TEST_CASE("Each method answers with the same digits every time") {
  const auto pair = test::pair_of_views(7, 0.07);
  for (const std::string& method : registration_methods()) {
    const auto first = run_method(method, pair.target_m, pair.source_m, pair.guess);
    const auto second = run_method(method, pair.target_m, pair.source_m, pair.guess);
    CHECK(first.T_target_source.matrix() == second.T_target_source.matrix());
    CHECK(first.rmse_m == second.rmse_m);
    CHECK(first.nodes == second.nodes);
  }
}

TEST_CASE("A method that does not exist is refused with those that do") {
  const StemPoints stems = test::random_stems(10, 20.0, 8);
  CHECK_THROWS_WITH(run_method("ndt", stems, stems),
                    Catch::Contains("\"ndt\"") && Catch::Contains("icp, go_icp, landmarks"));
}

}  // namespace
