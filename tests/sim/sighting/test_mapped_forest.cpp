// Forests of points and their maps: density, shares, noise, and the same digits again.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "algo/types/user_error.h"
#include "sim/sighting/mapped_forest.h"

using namespace honka;
using namespace honka::sim;

namespace {

SpacingSettings quick_spacing(const std::string& process) {
  SpacingSettings spacing;
  spacing.process = process;
  std::get<Strauss>(spacing.processes).sweeps = 3;
  return spacing;
}

double share(const std::vector<std::uint8_t>& flags) {
  return std::accumulate(flags.begin(), flags.end(), 0.0) / static_cast<double>(flags.size());
}

}  // namespace

TEST_CASE("Every spacing process gives the stems and the density asked for") {
  const auto process = GENERATE(from_range(spacing_process_names()));
  MappingSettings mapping;
  mapping.stems = 1500;
  const auto forest = make_mapped_forest(quick_spacing(process), 600.0, mapping, 3);
  CAPTURE(process);
  CHECK(forest->map_m == forest->trees_m);
  CHECK(forest->trees_m.size() == 1500);
  CHECK(forest->trees_m.size() / (forest->box_m.volume() * 1e-4) == Approx(600.0));
  for (const auto& tree_m : forest->trees_m) CHECK(forest->box_m.contains(tree_m));
}

TEST_CASE("A map lacks, moves and keeps what was asked for") {
  MappingSettings mapping;
  mapping.stems = 20000;
  mapping.noise_m = 0.1;
  mapping.missed_share = 0.2;
  mapping.felled_share = 0.3;
  const auto forest = make_mapped_forest(quick_spacing("poisson"), 367.0, mapping, 3);
  CHECK(share(forest->in_map) == Approx(0.8).margin(0.01));
  CHECK(share(forest->standing) == Approx(0.7).margin(0.01));
  double squares = 0.0;
  std::size_t row = 0;
  for (std::size_t i = 0; i < forest->trees_m.size(); ++i) {
    if (forest->in_map[i] != 0)
      squares += (forest->map_m[row++] - forest->trees_m[i]).squaredNorm();
  }
  REQUIRE(row == forest->map_m.size());
  CHECK(std::sqrt(0.5 * squares / static_cast<double>(row)) == Approx(0.1).margin(0.003));
}

TEST_CASE("Trees that have grown up since the map was made stand and are not in it") {
  MappingSettings mapping;
  mapping.stems = 20000;
  mapping.noise_m = 0.1;
  mapping.missed_share = 0.2;
  mapping.felled_share = 0.3;
  const auto before = make_mapped_forest(quick_spacing("poisson"), 367.0, mapping, 3);
  mapping.grown_share = 0.25;
  const auto after = make_mapped_forest(quick_spacing("poisson"), 367.0, mapping, 3);
  CHECK(share(after->in_map) == Approx(0.75 * 0.8).margin(0.01));
  CHECK(share(after->standing) == Approx(0.75 * 0.7 + 0.25).margin(0.01));
  // The others keep place, noise and fate.
  std::size_t row_before = 0, row_after = 0, grown = 0;
  for (std::size_t i = 0; i < before->trees_m.size(); ++i) {
    REQUIRE(after->trees_m[i] == before->trees_m[i]);
    if (after->in_map[i] != 0) {
      CHECK(after->map_m[row_after++] == before->map_m[row_before]);
      CHECK(after->standing[i] == before->standing[i]);
    } else if (before->in_map[i] != 0) {
      CHECK(after->standing[i] == 1);
      ++grown;
    }
    row_before += before->in_map[i];
  }
  CHECK(static_cast<double>(grown) / 20000.0 == Approx(0.25 * 0.8).margin(0.01));
}

TEST_CASE("A large forest is made of tiles that differ, and is as dense at their seams") {
  MappingSettings mapping;
  mapping.stems = 45000;  // 3 x 3 tiles
  const auto forest = make_mapped_forest(quick_spacing("strauss"), 400.0, mapping, 3);
  REQUIRE(forest->trees_m.size() == 45000);
  const double tile_m = forest->box_m.sizes().x() / 3.0;
  const Eigen::Vector2d low_m = forest->box_m.min();
  double near_seam = 0.0;
  const double band_m = 10.0;
  for (const auto& tree_m : forest->trees_m) {
    const double from_seam_m = std::abs(tree_m.x() - low_m.x() - tile_m);
    if (from_seam_m < band_m) near_seam += 1.0;
  }
  const double band_ha = 2.0 * band_m * forest->box_m.sizes().y() * 1e-4;
  CHECK(near_seam / band_ha == Approx(400.0).epsilon(0.1));
  std::size_t repeated = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const Eigen::Vector2d beside_m = forest->trees_m[i] + Eigen::Vector2d(tile_m, 0.0);
    if (forest->near->any_within(beside_m, 0.05)) ++repeated;
  }
  CHECK(repeated < 5);
}

TEST_CASE("A forest is the hash of its seed") {
  const auto make = [](std::uint64_t seed) {
    return make_mapped_forest(quick_spacing("strauss"), 367.0, MappingSettings{500}, seed);
  };
  CHECK(make(1)->map_m == make(1)->map_m);
  CHECK(make(1)->map_m != make(2)->map_m);
}

TEST_CASE("Poses keep from the border and from trees, and look everywhere") {
  const auto forest = make_mapped_forest(quick_spacing("poisson"), 1000.0, MappingSettings{}, 3);
  const double inside_m = 0.5 * forest->box_m.sizes().x() - 30.0;
  Eigen::Vector2d mean_heading = Eigen::Vector2d::Zero();
  for (std::uint64_t q = 0; q < 500; ++q) {
    const Pose2 pose = draw_pose(*forest, 30.0, 5, q);
    CHECK(pose.translation_m.cwiseAbs().maxCoeff() <= inside_m);
    CHECK(forest->near->nearest(pose.translation_m)->distance_m >= 1.0);
    mean_heading += Eigen::Vector2d(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad)) / 500.0;
  }
  CHECK(mean_heading.norm() < 0.15);
}

TEST_CASE("A border that leaves no place is the user's mistake") {
  const auto forest = make_mapped_forest(quick_spacing("poisson"), 367.0, MappingSettings{100}, 3);
  CHECK_THROWS_WITH(draw_pose(*forest, 30.0, 5, 0), Catch::Contains("sighting.border_m"));
}
