// What a detector lists: shares, noise and view, against the forest they were made of.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "sim/sighting/sight.h"

using namespace honka;
using namespace honka::sim;

namespace {

constexpr double kSightDensityPerHa = 367.0;

std::unique_ptr<MappedForest> sight_forest(const MappingSettings& mapping = {},
                                           std::uint64_t seed = 1) {
  SpacingSettings spacing;
  std::get<Strauss>(spacing.processes).sweeps = 5;
  return make_mapped_forest(spacing, kSightDensityPerHa, mapping, seed);
}

/// Lists at so many places, 30 m inside the border.
std::vector<std::pair<Pose2, Sighting>> look_around(const MappedForest& forest,
                                                    const SightingSettings& settings, int queries,
                                                    std::uint64_t seed = 7) {
  std::vector<std::pair<Pose2, Sighting>> all;
  for (std::uint64_t q = 0; q < static_cast<std::uint64_t>(queries); ++q) {
    const Pose2 pose = draw_pose(forest, 30.0, seed, q);
    all.emplace_back(pose, sight(forest, pose, settings, seed, q));
  }
  return all;
}

}  // namespace

TEST_CASE("A perfect detector lists every tree in range and view, and no other") {
  const auto forest = sight_forest();
  SightingSettings settings;
  settings.noise_m = 0.0;
  for (const auto& [T_world_sensor, list] : look_around(*forest, settings, 20)) {
    std::set<std::int32_t> expected;
    for (std::size_t i = 0; i < forest->trees_m.size(); ++i) {
      const Eigen::Vector2d place_m = T_world_sensor.inverse() * forest->trees_m[i];
      const double bearing_deg = rad_to_deg(std::atan2(place_m.y(), place_m.x()));
      if (place_m.norm() < 30.0 && std::abs(bearing_deg) <= 105.0) {
        expected.insert(static_cast<std::int32_t>(i));
      }
    }
    CHECK(std::set<std::int32_t>(list.trees.begin(), list.trees.end()) == expected);
    REQUIRE(list.trees.size() == expected.size());
    for (std::size_t k = 0; k < list.trees.size(); ++k) {
      const auto tree = static_cast<std::size_t>(list.trees[k]);
      const Eigen::Vector2d place_m = T_world_sensor * list.stems_in_sensor_m[k];
      CHECK((place_m - forest->trees_m[tree]).norm() < 1e-9);
    }
  }
}

TEST_CASE("Noise, bias and shares are those asked for") {
  const auto forest = sight_forest();
  SightingSettings settings;
  settings.noise_m = 0.2;
  settings.radial_bias_m = 0.1;
  settings.missed_share = 0.3;
  settings.false_share = 0.25;
  double listed = 0.0, true_stems = 0.0, in_view = 0.0, squares = 0.0, radial = 0.0;
  for (const auto& [T_world_sensor, list] : look_around(*forest, settings, 150)) {
    in_view += static_cast<double>(
        sight(*forest, T_world_sensor, SightingSettings{}, 1, 0).stems_in_sensor_m.size());
    listed += static_cast<double>(list.trees.size());
    for (std::size_t k = 0; k < list.trees.size(); ++k) {
      if (list.trees[k] < 0) continue;
      true_stems += 1.0;
      const auto tree = static_cast<std::size_t>(list.trees[k]);
      const Eigen::Vector2d place_m = T_world_sensor.inverse() * forest->trees_m[tree];
      const Eigen::Vector2d error_m = list.stems_in_sensor_m[k] - place_m;
      radial += error_m.dot(place_m.normalized());
      squares += (error_m + 0.1 * place_m.normalized()).squaredNorm();
    }
  }
  REQUIRE(true_stems > 5000.0);
  CHECK(true_stems / in_view == Approx(0.7).margin(0.02));
  CHECK(1.0 - true_stems / listed == Approx(0.25).margin(0.01));
  CHECK(radial / true_stems == Approx(-0.1).margin(0.01));
  CHECK(std::sqrt(0.5 * squares / true_stems) == Approx(0.2).margin(0.01));
}

TEST_CASE("A short list holds the nearest stems, false ones counted and as near") {
  const auto forest = sight_forest();
  SightingSettings settings;
  settings.noise_m = 0.0;
  settings.most_stems = 20;
  settings.false_share = 0.2;
  for (const auto& [pose, list] : look_around(*forest, settings, 20)) {
    REQUIRE(list.trees.size() == 20);
    CHECK(std::count(list.trees.begin(), list.trees.end(), -1) == 4);
    double reach_m = 0.0;
    for (std::size_t k = 0; k < 16; ++k) {
      const double distance_m = list.stems_in_sensor_m[k].norm();
      CHECK(distance_m >= reach_m);
      reach_m = distance_m;
    }
    for (std::size_t k = 16; k < 20; ++k) CHECK(list.stems_in_sensor_m[k].norm() <= reach_m);
  }
}

TEST_CASE("A list is the hash of its query: the same alone and among others, another elsewhere") {
  const auto forest = sight_forest();
  SightingSettings settings;
  settings.missed_share = 0.2;
  settings.false_share = 0.2;
  const auto all = look_around(*forest, settings, 5);
  const Pose2 pose = draw_pose(*forest, 30.0, 7, 3);
  const Sighting alone = sight(*forest, pose, settings, 7, 3);
  CHECK(alone.stems_in_sensor_m == all[3].second.stems_in_sensor_m);
  CHECK(alone.trees == all[3].second.trees);
  CHECK(sight(*forest, pose, settings, 7, 4).stems_in_sensor_m != alone.stems_in_sensor_m);
  CHECK(sight(*forest, pose, settings, 8, 3).stems_in_sensor_m != alone.stems_in_sensor_m);
}

TEST_CASE("Nothing in view gives an empty list") {
  MappingSettings mapping;
  mapping.stems = 60;
  mapping.felled_share = 1.0;
  const auto forest = sight_forest(mapping);
  SightingSettings settings;
  settings.false_share = 0.5;
  CHECK(sight(*forest, Pose2{}, settings, 1, 0).stems_in_sensor_m.empty());
}
