#include <catch2/catch.hpp>

#include "algo/slam/match_quality.h"
#include "tests/algo/slam/core_world.h"
#include "tests/support/slam_case.h"

using namespace honka;

TEST_CASE("Matches equal the reference pairs") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM cases are not there");
    return;
  }
  const auto pairs = test::read_number_rows(*folder / "case0_pairs.csv");
  const auto frames = test::read_frame_points(*folder / "case0_points.csv.gz");
  const auto truth = test::read_pose_rows(*folder / "case0_true_pose.csv");
  const auto chain = test::read_pose_rows(*folder / "case0_chain_pose.csv");
  for (const auto& pair : pairs) {
    const auto i = static_cast<std::size_t>(pair[0]), j = static_cast<std::size_t>(pair[1]);
    for (const auto& [poses, first, points] : {std::tuple{&truth, 4U, 7U}, {&chain, 9U, 12U}}) {
      const Pose3 T_j_i = (*poses)[j].inverse() * (*poses)[i];
      const MatchQuality match = judge_match(frames[j], frames[i], T_j_i, ViewCone{}, {});
      CHECK(match.points == static_cast<int>(pair[points]));
      if (pair[first] > 9.8) {  // the reference's mark of a match that it did not judge
        CHECK(std::isinf(match.error_m));
        continue;
      }
      CHECK(match.error_m == Approx(pair[first]).margin(2e-6));
      CHECK(match.mean_m == Approx(pair[first + 1]).margin(2e-6));
      CHECK(match.share == Approx(pair[first + 2]).margin(1e-9));
    }
  }
}

TEST_CASE("A match judged on paper") {
  // Ten stems a row 10 m apart; the source lies 0.1 m aside, four of its points a metre.
  test::StemPoints target, source;
  for (int k = 0; k < 10; ++k) {
    target.emplace_back(1.0 + 3.0 * k, 0.0, 0.0);
    source.emplace_back(1.0 + 3.0 * k, k < 4 ? 1.0 : 0.1, 0.0);
  }
  MatchQualitySettings settings;
  settings.inlier_ratio = 0.6;
  MatchQuality match = judge_match(target, source, Pose3::Identity(), ViewCone{}, settings);
  CHECK(match.points == 10);
  CHECK(match.error_m == Approx(0.1));
  CHECK(match.mean_m == Approx(0.46));
  CHECK(match.share == Approx(0.6));

  settings.inlier_ratio = 0.61;  // seven of ten
  match = judge_match(target, source, Pose3::Identity(), ViewCone{}, settings);
  CHECK(match.error_m == Approx(std::sqrt((6.0 * 0.01 + 1.0) / 7.0)));

  // Behind the target's cone nothing is judged; nor where fewer than eight points are seen.
  const Pose3 behind(Eigen::Translation3d(-40.0, 0.0, 0.0));
  match = judge_match(target, source, behind, ViewCone{}, settings);
  CHECK(match.points < 8);
  CHECK(std::isinf(match.error_m));
  CHECK(match.share == 0.0);
}

TEST_CASE("Bad clouds and poses give no NaN") {
  const test::StemPoints stems = test::random_stems(40, 40.0, 1);
  test::StemPoints broken = stems;
  broken[3].x() = std::nan("");
  broken[4].z() = INFINITY;
  Pose3 bad = Pose3::Identity();
  bad.translation().x() = std::nan("");
  const MatchQualitySettings settings;
  for (const auto& [target, source, pose] :
       std::vector<std::tuple<test::StemPoints, test::StemPoints, Pose3>>{
           {{}, stems, Pose3::Identity()},
           {stems, {}, Pose3::Identity()},
           {broken, stems, Pose3::Identity()},
           {stems, broken, Pose3::Identity()},
           {stems, stems, bad}}) {
    const MatchQuality match = judge_match(target, source, pose, ViewCone{}, settings);
    CHECK_FALSE(std::isnan(match.error_m));
    CHECK_FALSE(std::isnan(match.mean_m));
    CHECK(match.share >= 0.0);
    CHECK(match.share <= 1.0);
  }
  CHECK(judge_match(broken, stems, Pose3::Identity(), ViewCone{}, settings).share < 1.0);
}
