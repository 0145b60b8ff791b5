// Every intermediate result against those of an independent implementation.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "algo/localize/li2020/star.h"
#include "tests/algo/localize/cases.h"

using namespace honka;
using namespace honka::test;
using nlohmann::json;

namespace {

std::array<int, 3> sorted_corners(std::array<std::int32_t, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

void check_graph(const DelaunayGraph& graph, const json& steps) {
  std::set<int> hull;
  for (std::size_t i = 0; i < graph.on_hull.size(); ++i) {
    if (graph.on_hull[i] != 0) hull.insert(static_cast<int>(i));
  }
  CHECK(hull == steps["hull"].get<std::set<int>>());
  std::set<std::array<int, 3>> triangles;
  for (const auto& t : graph.triangles) triangles.insert(sorted_corners(t.vertices));
  CHECK(triangles == steps["triangles"].get<std::set<std::array<int, 3>>>());
}

/// Li2020 Eq. (1), turned so that it starts at neighbour r.
bool same_features(const TriangleStar& star, const std::vector<double>& features, std::size_t r) {
  const auto close = [](double a, double b) { return std::abs(a - b) < 2e-6; };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = i == 0 ? 0 : (i - 1 + r) % 3 + 1;
    if (!close(star.area_m2[j], features[2 * i])) return false;
    if (!close(star.perimeter_squared_m2[j], features[2 * i + 1])) return false;
  }
  return true;
}

bool same_vertices(const TriangleStar& star, const std::vector<int>& vertices, std::size_t r) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + r) % 3;
    if (star.vertices[j] != vertices[i] || star.vertices[j + 3] != vertices[i + 3]) return false;
  }
  return true;
}

void check_stars(const std::vector<TriangleStar>& stars, const json& expected) {
  REQUIRE(stars.size() == expected.size());
  for (const auto& e : expected) {
    const auto vertices = e["verts6"].get<std::vector<int>>();
    const auto features = e["features_cyclic"].get<std::vector<double>>();
    const bool found = std::any_of(stars.begin(), stars.end(), [&](const TriangleStar& star) {
      for (std::size_t r = 0; r < 3; ++r) {
        if (same_vertices(star, vertices, r) && same_features(star, features, r)) return true;
      }
      return false;
    });
    INFO(e.dump());
    CHECK(found);
  }
}

std::set<std::pair<int, int>> pairs_of(const StarMatch& match) {
  std::set<std::pair<int, int>> pairs;
  for (const VertexPair& p : match.pairs) pairs.emplace(p.local, p.map);
  return pairs;
}

void check_match(const StarMatch& match, const json& expected) {
  INFO(expected.dump());
  CHECK(match.dissimilarity_m2 == Approx(expected["D"].get<double>()).margin(2e-6));
  CHECK(pairs_of(match) == expected["f"].get<std::set<std::pair<int, int>>>());
  CHECK(match.theta_rad == Approx(expected["theta"].get<double>()).margin(1e-9));
  CHECK(match.cost_m == Approx(expected["eq3_cost"].get<double>()).margin(1e-9));
  for (const int axis : {0, 1}) {
    const auto slot = static_cast<std::size_t>(axis);
    CHECK(match.printed_translation_m[axis] ==
          Approx(expected["p_t"][slot].get<double>()).margin(1e-6));
    CHECK(match.translation_m[axis] == Approx(expected["t"][slot].get<double>()).margin(1e-6));
  }
}

void check_steps(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const json steps = read_json(file);
  const auto name = steps["id"].get<std::string>();
  const std::string set = name.substr(0, name.find('_'));
  INFO(name);
  const auto stems = read_stems(folder / set / (name + ".csv"));
  const auto map = read_stems(folder / set / "map.csv");
  const DelaunayGraph graph = build_delaunay(stems);
  check_graph(graph, steps);
  check_stars(stars_of(graph, StarChoice::kNoHullVertex), steps["stars"]);

  // Matches by the corners of their local star.
  const DelaunayGraph map_graph = build_delaunay(map);
  const auto answer = matcher_for(folder, set)->locate(stems);
  std::map<std::array<int, 3>, const StarMatch*> by_corners;
  for (const StarMatch& m : answer.star_matches) {
    const auto& centre = graph.triangles[static_cast<std::size_t>(m.local_triangle)];
    by_corners[sorted_corners(centre.vertices)] = &m;
  }
  REQUIRE(by_corners.size() == steps["matches"].size());
  int k = 0;
  for (const auto& e : steps["matches"]) {
    auto corners = steps["stars"][e["local_star"].get<std::size_t>()]["verts6"]
                       .get<std::vector<std::int32_t>>();
    const StarMatch* match = by_corners[sorted_corners({corners[0], corners[1], corners[2]})];
    REQUIRE(match != nullptr);
    check_match(*match, e);
    const auto& centre = map_graph.triangles[static_cast<std::size_t>(match->map_triangle)];
    CHECK(sorted_corners(centre.vertices) == e["map_centre"].get<std::array<int, 3>>());
    if (k++ == steps["eq4_k"]) {
      CHECK(match == &answer.star_matches[static_cast<std::size_t>(answer.chosen)]);
    }
  }
  CHECK(answer.T_map_local.yaw_rad == Approx(steps["theta"].get<double>()).margin(1e-9));
  CHECK(answer.T_map_local.translation_m.x() == Approx(steps["t"][0].get<double>()).margin(1e-6));
  CHECK(answer.T_map_local.translation_m.y() == Approx(steps["t"][1].get<double>()).margin(1e-6));
}

int check_folder(const std::filesystem::path& folder) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind("steps_", 0) != 0) continue;
    check_steps(folder, entry.path());
    ++files;
  }
  return files;
}

}  // namespace

TEST_CASE("intermediate results of the committed cases") { CHECK(check_folder(own_cases()) == 4); }

TEST_CASE("intermediate results of all cases") {
  const auto folder = shared_cases();
  if (!folder) {
    WARN("skipped: shared/data/localization_cases is not here");
    return;
  }
  CHECK(check_folder(*folder) == 17);
}
