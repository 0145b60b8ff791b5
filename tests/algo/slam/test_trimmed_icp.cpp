#include <catch2/catch.hpp>
#include <numeric>

#include "algo/slam/registration/trimmed_icp.h"
#include "tests/algo/slam/core_world.h"
#include "tests/support/slam_case.h"

using namespace honka;

namespace {

const Pose3 kIcpTruth = pose_from_rpy({0.4, -0.2, 0.05}, 0.01, -0.02, 0.03);

double icp_pose_gap(const Pose3& a, const Pose3& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("Trimmed ICP equals the reference: pose, RMSE and number of steps") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM cases are not there");
    return;
  }
  const auto pairs = test::read_number_rows(*folder / "case0_pairs.csv");
  const auto frames = test::read_frame_points(*folder / "case0_points.csv.gz");
  const auto truth = test::read_pose_rows(*folder / "case0_true_pose.csv");
  const auto found = test::read_pose_rows(*folder / "case0_pairs.csv", 15);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(pairs[k][0]), j = static_cast<std::size_t>(pairs[k][1]);
    const Registration icp =
        trimmed_icp(frames[j], frames[i], Pose3(truth[j].inverse() * truth[i]), {});
    INFO("frames " << i << " and " << j);
    CHECK(icp.usable());
    CHECK(icp_pose_gap(icp.T_target_source, found[k]) < 2e-6);
    CHECK(icp.rmse_m == Approx(pairs[k][13]).margin(2e-6));
    CHECK(icp.iterations == static_cast<int>(pairs[k][14]));
  }
}

TEST_CASE("Without noise the exact motion is found, whatever part is trimmed") {
  const test::StemPoints stems = test::random_stems(110, 60.0, 1);
  test::StemPoints source;
  for (const Eigen::Vector3d& stem : stems) source.emplace_back(kIcpTruth.inverse() * stem);
  for (const double ratio : {0.05, 0.4, 0.7, 0.95, 1.0}) {
    TrimmedIcpSettings settings;
    settings.inlier_ratio = ratio;
    const Registration icp = trimmed_icp(stems, source, kIcpTruth, settings);
    CHECK(icp_pose_gap(icp.T_target_source, kIcpTruth) < 1e-12);
    settings.max_iterations = 60;
    const Registration from_afar = trimmed_icp(stems, source, Pose3::Identity(), settings);
    if (ratio >= 0.4) CHECK(icp_pose_gap(from_afar.T_target_source, kIcpTruth) < 1e-9);
    CHECK(icp.share == 1.0);
    CHECK(icp.inliers == 110);
  }
}

TEST_CASE("Trimming keeps a third of strangers out of the fit") {
  const test::StemPoints stems = test::random_stems(120, 60.0, 2);
  test::StemPoints source;
  RandomStream random(11, "strangers");
  for (std::size_t k = 0; k < stems.size(); ++k) {
    source.emplace_back(kIcpTruth.inverse() * stems[k]);
    if (k % 3 == 0) source.back() += Eigen::Vector3d(random.uniform(1.0, 2.0), 0.0, 0.0);
  }
  TrimmedIcpSettings settings;
  settings.inlier_ratio = 0.6;
  CHECK(icp_pose_gap(trimmed_icp(stems, source, Pose3::Identity(), settings).T_target_source,
                     kIcpTruth) < 1e-9);
  settings.inlier_ratio = 1.0;
  CHECK(icp_pose_gap(trimmed_icp(stems, source, Pose3::Identity(), settings).T_target_source,
                     kIcpTruth) > 0.05);
}

TEST_CASE("Clouds that cannot be registered get a status and keep the guess") {
  const test::StemPoints good = test::random_stems(30, 40.0, 4);
  test::StemPoints line, nan = good;
  for (int k = 0; k < 30; ++k) line.emplace_back(k, 2.0 * k, -0.5 * k);
  nan[7].y() = std::nan("");
  const test::StemPoints twice = {good[0], good[1], good[0], good[1], good[0]};
  const Pose3 guess = pose_from_rpy({1.0, 2.0, 0.0}, 0.0, 0.0, 0.3);
  using Status = RegistrationStatus;
  for (const auto& [bad, status] : std::vector<std::pair<test::StemPoints, Status>>{
           {{}, Status::kTooFewPoints},
           {{good[0]}, Status::kTooFewPoints},
           {{good[0], good[1]}, Status::kTooFewPoints},
           {line, Status::kTooFewPoints},
           {twice, Status::kTooFewPoints},
           {test::StemPoints(9, good[0]), Status::kTooFewPoints},
           {nan, Status::kNotFinite}}) {
    for (const Registration& icp :
         {trimmed_icp(bad, good, guess, {}), trimmed_icp(good, bad, guess, {})}) {
      CHECK(icp.status == status);
      CHECK(icp.T_target_source.matrix() == guess.matrix());
      CHECK_FALSE(icp.usable());
    }
  }
  Pose3 bad_guess = guess;
  bad_guess.linear()(0, 0) = std::nan("");
  const Registration icp = trimmed_icp(good, good, bad_guess, {});
  CHECK(icp.status == Status::kNotFinite);
  CHECK(icp.T_target_source.matrix().allFinite());
  CHECK(registration_status_name(icp.status) == "not_finite");
}

TEST_CASE("Poses stay finite and rigid for duplicates, disjoint clouds and huge coordinates") {
  const test::StemPoints stems = test::random_stems(40, 40.0, 5);
  test::StemPoints doubled = stems, apart = stems, huge = stems;
  doubled.insert(doubled.end(), stems.begin(), stems.end());
  for (Eigen::Vector3d& p : apart) p.x() += 500.0;
  for (Eigen::Vector3d& p : huge) p *= 1e200;
  const test::StemPoints three = {stems[0], stems[1], stems[2]};
  for (const test::StemPoints& source : {doubled, apart, huge, three}) {
    for (const double ratio : {0.01, 0.4, 1.0}) {
      TrimmedIcpSettings settings;
      settings.inlier_ratio = ratio;
      const Registration icp = trimmed_icp(stems, source, Pose3::Identity(), settings);
      const Eigen::Matrix3d R = icp.T_target_source.linear();
      CHECK(icp.T_target_source.matrix().allFinite());
      CHECK((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-12);
      CHECK(R.determinant() > 0.0);
    }
  }
}
