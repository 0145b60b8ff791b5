// Landmark voting: any pose without a guess.
#include <algorithm>
#include <catch2/catch.hpp>

#include "algo/slam/registration/landmark_triangles.h"
#include "algo/slam/registration/landmark_voting.h"
#include "algo/slam/registration/vote_places.h"
#include "tests/algo/slam/registration_pairs.h"

namespace {

using namespace honka;

TEST_CASE("Four stems make four triangles, each once, sides from the longest") {
  const std::vector<Eigen::Vector2d> stems = {{0, 0}, {4, 0}, {0, 3}, {9, 9}};
  const auto triangles = landmark_triangles(stems, 3);
  REQUIRE(triangles.size() == 4);
  const auto longest_side = [](const auto& a, const auto& b) {
    return a.sides_m[0] < b.sides_m[0];
  };
  const LandmarkTriangle& smallest =
      *std::min_element(triangles.begin(), triangles.end(), longest_side);
  CHECK(smallest.sides_m[0] == Approx(5.0));
  CHECK(smallest.sides_m[1] == Approx(4.0));
  CHECK(smallest.sides_m[2] == Approx(3.0));
  CHECK(smallest.corners == std::array<std::uint32_t, 3>{0, 2, 1});  // opposite to its sides
  CHECK_FALSE(smallest.is_counter_clockwise);
  for (std::size_t k = 1; k < triangles.size(); ++k) {
    const bool same_turn =
        triangles[k].is_counter_clockwise == triangles[k - 1].is_counter_clockwise;
    if (same_turn) CHECK(triangles[k].sides_m[0] >= triangles[k - 1].sides_m[0]);
    if (!same_turn) CHECK(triangles[k].is_counter_clockwise);
  }
}

TEST_CASE("Alike triangles vote for the pose between them, mirrored ones do not") {
  const std::vector<Eigen::Vector2d> source = {{0, 0}, {7, 0}, {2, 4}};
  const Pose2 T_target_source{{3.0, -1.0}, 2.5};
  std::vector<Eigen::Vector2d> target, mirrored;
  for (const auto& p : source) {
    target.push_back(T_target_source * p);
    mirrored.emplace_back(-p.x(), p.y());
  }
  const auto of_source = landmark_triangles(source, 2);
  const auto votes = triangle_votes(target, landmark_triangles(target, 2), source, of_source, 0.1);
  REQUIRE(votes.size() == 1);
  CHECK(votes[0].yaw_rad == Approx(2.5));
  CHECK(votes[0].shift_m.x() == Approx(3.0));
  CHECK(votes[0].shift_m.y() == Approx(-1.0));
  CHECK(triangle_votes(mirrored, landmark_triangles(mirrored, 2), source, of_source, 0.1).empty());

  const auto places = most_voted(votes, 5);
  REQUIRE(places.size() == 1);
  CHECK(places[0].yaw_rad == Approx(2.5));
}

TEST_CASE("The most voted place is counted with its neighbours, across 180° too") {
  std::vector<TriangleVote> votes;
  const auto vote = [&](double yaw_rad, double x_m, int times) {
    for (int k = 0; k < times; ++k) {
      votes.push_back({yaw_rad, std::sin(yaw_rad), std::cos(yaw_rad), {x_m, 0.0}});
    }
  };
  vote(1.0, 30.5, 5);
  vote(3.13, 10.5, 4);
  vote(-3.13, 10.5, 3);
  const auto places = most_voted(votes, 5);
  REQUIRE(places.size() == 2);
  CHECK(std::abs(wrap_to_pi(places[0].yaw_rad - 3.14)) < 0.02);
  CHECK(places[0].translation_m.x() == Approx(10.5));
  CHECK(places[1].translation_m.x() == Approx(30.5));
}

TEST_CASE("Landmarks find any pose of clean and of noisy views") {
  for (std::uint64_t id = 0; id < 20; ++id) {
    auto pair = test::pair_of_views(id, id % 2 == 0 ? 0.0 : 0.07);
    const Pose3 T_moved_target =
        pose_from_rpy({100.0, -70.0, 2.0}, 0.0, 0.0, 0.3 * static_cast<double>(id));
    for (auto& p : pair.target_m) p = T_moved_target * p;
    const Pose3 truth = T_moved_target * pair.T_target_source;
    const auto result = register_by_landmarks(pair.target_m, pair.source_m, {});
    CAPTURE(id);
    CHECK(result.status == RegistrationStatus::kRegistered);
    CHECK(test::planar_distance_m(result.T_target_source, truth) < 0.1);
    CHECK(test::yaw_difference_deg(result.T_target_source, truth) < 0.4);
    CHECK((result.T_target_source.translation() - truth.translation()).norm() < 0.2);
    CHECK(result.share > 0.8);
  }
}

TEST_CASE("Views of different stands are refused") {
  for (std::uint64_t id = 0; id < 20; ++id) {
    const auto a = test::pair_of_views(id, 0.07);
    const auto b = test::pair_of_views(id + 100, 0.07);
    const auto result = register_by_landmarks(a.target_m, b.source_m, {}, ViewCone{});
    CHECK(result.status == RegistrationStatus::kUnverified);
    CHECK(result.T_target_source.matrix().allFinite());
  }
}

TEST_CASE("A planted grid fits onto itself somewhere, soon") {
  test::StemPoints grid;
  for (int k = 0; k < 400; ++k) grid.emplace_back(2.5 * (k % 20), 2.5 * (k / 20), 0.0);
  const auto result = register_by_landmarks(grid, grid, {});
  CHECK(result.status == RegistrationStatus::kRegistered);
  CHECK(result.rmse_m < 0.01);
}

TEST_CASE("Case 0: landmarks are right in 99.5 % where 40 % have partners", "[case0]") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM case is absent");
    return;
  }
  const auto pairs = test::pairs_of_case(*folder, 400, 0.4);
  int right = 0, registered_wrong = 0;
  for (const auto& pair : pairs) {
    const auto result = register_by_landmarks(pair.target_m, pair.source_m, {}, ViewCone{});
    const bool is_right = test::is_right(result.T_target_source, pair.T_target_source);
    right += is_right && result.usable() ? 1 : 0;
    registered_wrong += result.usable() && !is_right ? 1 : 0;
  }
  CHECK(right >= 398);
  CHECK(registered_wrong == 0);
}

}  // namespace
