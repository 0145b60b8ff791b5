// Laws of the li2020 matcher over every variant.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "algo/localize/li2020/li2020.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

using Points = std::vector<Eigen::Vector2d>;

/// 400 stems in 80 m × 80 m, no two closer than 1.5 m.
Points forest(std::uint64_t seed = 1) {
  RandomStream stream(seed, "localize_test_forest");
  Points stems;
  while (stems.size() < 400) {
    const double x = stream.uniform(0.0, 80.0);
    const Eigen::Vector2d p(x, stream.uniform(0.0, 80.0));
    const bool free = std::none_of(stems.begin(), stems.end(),
                                   [&](const auto& q) { return (p - q).norm() < 1.5; });
    if (free) stems.push_back(p);
  }
  return stems;
}

/// What is seen within 25 m from a pose in the map, with centimetres of noise.
Points seen_from(const Points& map, const Pose2& T_map_local, double noise_m = 0.01) {
  RandomStream stream(2, "localize_test_noise");
  Points local;
  for (const auto& p : map) {
    if ((p - T_map_local.translation_m).norm() > 25.0) continue;
    local.push_back(T_map_local.inverse() * p);
    local.back().x() += stream.normal(0.0, noise_m);
    local.back().y() += stream.normal(0.0, noise_m);
  }
  return local;
}

Points moved(const Pose2& T, Points points) {
  for (auto& p : points) p = T * p;
  return points;
}

Points permuted(const Points& points) {
  Points result = points;
  std::rotate(result.begin(), result.begin() + 7, result.end());
  std::reverse(result.begin(), result.begin() + 20);
  return result;
}

Li2020Settings variant(const std::string& pairing, const std::string& selection, double gate_m) {
  Li2020Settings settings;
  settings.pairing = pairing;
  settings.selection = selection;
  settings.vertex_gate_m = gate_m;
  return settings;
}

const Pose2 kTruth{{41.0, 38.0}, 0.8};

void check_close(const Pose2& a, const Pose2& b, double bound_m, double bound_rad) {
  CHECK((a.translation_m - b.translation_m).norm() < bound_m);
  CHECK(std::abs(wrap_to_pi(a.yaw_rad - b.yaw_rad)) < bound_rad);
}

}  // namespace

TEST_CASE("every variant finds the pose in a made forest") {
  const auto pairing = GENERATE(as<std::string>{}, "similar_edge", "least_side_sum");
  const auto selection = GENERATE(as<std::string>{}, "candidates", "box");
  const auto gate_m = GENERATE(0.0, 0.3);
  const Points map = forest();
  const Points local = seen_from(map, kTruth);
  const auto answer = Li2020Matcher(map, variant(pairing, selection, gate_m)).locate(local);
  CHECK(answer.accepted());
  CHECK(answer.agreeing <= answer.matches);
  CHECK(answer.matches <= answer.local_stars);
  CHECK(answer.inliers <= answer.stems);
  CHECK(answer.margin == Approx(double(answer.agreeing) / answer.matches));
  check_close(answer.T_map_local, kTruth, 0.1, 0.01);

  // Turning and moving either list turns and moves the pose with it.
  const Pose2 T{{1234.0, -567.0}, GENERATE(-2.9, 0.4, kPi)};
  const auto map_moved = Li2020Matcher(moved(T, map), variant(pairing, selection, gate_m));
  check_close(map_moved.locate(local).T_map_local, T * answer.T_map_local, 1e-6, 1e-8);
  const auto local_moved =
      Li2020Matcher(map, variant(pairing, selection, gate_m)).locate(moved(T, local));
  check_close(local_moved.T_map_local, answer.T_map_local * T.inverse(), 1e-4, 1e-8);
  CHECK(local_moved.agreeing == answer.agreeing);
}

TEST_CASE("the order of the lists does not change a digit") {
  const Points map = forest();
  const Points local = seen_from(map, kTruth, 0.05);
  const auto a = Li2020Matcher(map, {}).locate(local);
  const auto b = Li2020Matcher(permuted(map), {}).locate(permuted(local));
  REQUIRE(a.matches > 5);
  CHECK(a.T_map_local.translation_m == b.T_map_local.translation_m);
  CHECK(a.T_map_local.yaw_rad == b.T_map_local.yaw_rad);
  CHECK(a.matches == b.matches);
  CHECK(a.agreeing == b.agreeing);
  CHECK(a.cost_m == b.cost_m);
}

TEST_CASE("a mirrored map and another forest are refused") {
  const Points map = forest();
  const Points local = seen_from(map, kTruth);
  Points mirrored = map;
  for (auto& p : mirrored) p.x() = -p.x();
  CHECK(Li2020Matcher(mirrored, {}).locate(local).verdict == Verdict::kNotInMap);
  CHECK(Li2020Matcher(forest(77), {}).locate(local).verdict == Verdict::kNotInMap);
}

TEST_CASE("the matches are those of comparing all stars with all") {
  const Points map = forest();
  const Points local = seen_from(map, kTruth, 0.08);
  Li2020Settings settings;
  settings.tolerance_m2 = GENERATE(0.5, 4.5, 30.0);
  const Li2020Matcher matcher(map, settings);
  const auto answer = matcher.locate(local);

  const auto map_stars = stars_of(matcher.map_graph(), StarChoice::kThreeNeighbours);
  const auto local_stars = stars_of(build_delaunay(local), StarChoice::kNoHullVertex);
  int candidates = 0;
  std::size_t matches = 0;
  for (const TriangleStar& star : local_stars) {
    const TriangleStar* best = nullptr;
    double least = INFINITY;
    for (const TriangleStar& other : map_stars) {
      const auto like = compare_stars(star, other, settings.tolerance_m2, 3);
      if (!like) continue;
      ++candidates;
      if (like->dissimilarity_m2 >= least) continue;
      least = like->dissimilarity_m2;
      best = &other;
    }
    if (best == nullptr) continue;
    REQUIRE(matches < answer.star_matches.size());
    const StarMatch& match = answer.star_matches[matches++];
    CHECK(match.local_triangle == star.triangle);
    CHECK(match.map_triangle == best->triangle);
    CHECK(match.dissimilarity_m2 == Approx(least));
  }
  CHECK(static_cast<int>(matches) == answer.matches);
  CHECK(candidates == answer.candidates);
}

TEST_CASE("the vertex gate keeps only matches that fit, and wide tolerances gain by it") {
  const Points map = forest();
  Li2020Settings settings;
  settings.tolerance_m2 = 30.0;
  const Points local = seen_from(map, kTruth, 0.05);
  const auto open = Li2020Matcher(map, settings).locate(local);
  settings.vertex_gate_m = 0.3;
  const auto gated = Li2020Matcher(map, settings).locate(local);
  for (const StarMatch& match : gated.star_matches) CHECK(match.cost_m <= 6 * 0.3);
  CHECK(gated.matches < open.matches);
  CHECK(gated.margin > open.margin);

  std::set<std::int32_t> paired;
  for (const StarMatch& match : open.star_matches) {
    if (!match.agrees) continue;
    for (const VertexPair& pair : match.pairs) paired.insert(pair.local);
  }
  CHECK(open.agreeing < open.matches);
  CHECK(open.inliers == static_cast<int>(paired.size()));
}

TEST_CASE("UTM-sized maps lose no digit") {
  const Eigen::Vector2d utm(654321.0, 6912345.0);
  Points map = forest();
  for (auto& p : map) p = (p * 1024.0).array().round() / 1024.0;  // so that adding utm is exact
  const Points local = seen_from(map, kTruth, 0.0);
  Points far = map;
  for (auto& p : far) p += utm;
  const auto near_answer = Li2020Matcher(map, {}).locate(local);
  const auto answer = Li2020Matcher(far, {}).locate(local);
  CHECK(answer.accepted());
  CHECK(answer.T_map_local.yaw_rad == near_answer.T_map_local.yaw_rad);
  CHECK(answer.cost_m == near_answer.cost_m);
  CHECK((answer.T_map_local.translation_m - utm - near_answer.T_map_local.translation_m).norm() <
        2e-9);
  for (const StarMatch& match : answer.star_matches) {
    CHECK((match.translation_m - answer.T_map_local.translation_m).norm() < 0.01);
  }
}
