#include "sim/sighting/mapped_forest.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/user_error.h"

namespace honka::sim {
namespace {

constexpr double kM2PerHa = 1e4;
constexpr double kFreeAroundSensor_m = 1.0;  // nobody parks a machine on a tree

/// Most stems of one run of a spacing process: beyond, its moves miss the cache and take 5 times as
/// long each.
constexpr std::int64_t kTileStems = 10000;

SpacingDomain square(const Eigen::Vector2d& low_m, double side_m, std::int64_t stems,
                     double density_per_ha) {
  SpacingDomain domain;
  domain.count = stems;
  domain.spacing_m = std::sqrt(kM2PerHa / density_per_ha);
  domain.box_m = Eigen::AlignedBox2d(low_m, low_m + Eigen::Vector2d::Constant(side_m));
  return domain;
}

/// Large forests in square tiles, each with a seed of its own. Each tile is a torus, so that the
/// density is even up to its sides; stems on two sides of a seam do not feel each other. Rows are
/// planted in one piece: they run on.
Points grow(const SpacingSettings& spacing, double density_per_ha, std::int64_t stems,
            double side_m, std::uint64_t seed) {
  std::int64_t tiles = 1;
  while (spacing.process != Rows::kName && stems / (tiles * tiles) > kTileStems) ++tiles;
  const double tile_m = side_m / static_cast<double>(tiles);
  const Eigen::Vector2d low_m = Eigen::Vector2d::Constant(-0.5 * side_m);
  Points trees_m;
  for (std::int64_t tile = 0; tile < tiles * tiles; ++tile) {
    const Eigen::Vector2d corner_m =
        low_m + tile_m * Eigen::Vector2d(static_cast<double>(tile % tiles),
                                         static_cast<double>(tile / tiles));
    const std::int64_t until = (tile + 1) * stems / (tiles * tiles);
    const SpacingDomain domain =
        square(corner_m, tile_m, until - tile * stems / (tiles * tiles), density_per_ha);
    const auto id = static_cast<std::uint64_t>(tile);
    const Points placed = place_stems(spacing, domain, derive_seed(seed, "forest_tile", {id}));
    trees_m.insert(trees_m.end(), placed.begin(), placed.end());
  }
  return trees_m;
}

/// What became of each tree: mapped or not, where, felled or not.
void map_trees(MappedForest& forest, const MappingSettings& mapping, std::uint64_t seed) {
  for (std::size_t i = 0; i < forest.trees_m.size(); ++i) {
    RandomStream stream(seed, "mapped_tree", {i});
    const bool found = stream.uniform() >= mapping.missed_share;
    const bool cut = stream.uniform() < mapping.felled_share;
    // One after the other: the order of arguments is the compiler's.
    const double y_error_m = stream.normal(0.0, mapping.noise_m);
    const double x_error_m = stream.normal(0.0, mapping.noise_m);
    const Eigen::Vector2d error_m(x_error_m, y_error_m);
    const bool grown = stream.uniform() < mapping.grown_share;
    const bool mapped = found && !grown;
    const bool felled = cut && !grown;
    forest.in_map.push_back(mapped ? 1 : 0);
    forest.standing.push_back(felled ? 0 : 1);
    if (mapped) forest.map_m.emplace_back(forest.trees_m[i] + error_m);
  }
}

bool is_clear(const MappedForest& forest, const Eigen::Vector2d& place_m) {
  const auto near = forest.near->within(place_m, kFreeAroundSensor_m);
  return std::none_of(near.begin(), near.end(),
                      [&](std::uint32_t tree) { return forest.standing[tree] != 0; });
}

}  // namespace

std::unique_ptr<MappedForest> make_mapped_forest(const SpacingSettings& spacing,
                                                 double density_per_ha,
                                                 const MappingSettings& mapping,
                                                 std::uint64_t seed) {
  const double side_m = std::sqrt(static_cast<double>(mapping.stems) * kM2PerHa / density_per_ha);
  const Eigen::Vector2d corner_m = Eigen::Vector2d::Constant(0.5 * side_m);
  auto forest = std::make_unique<MappedForest>();
  forest->box_m = Eigen::AlignedBox2d(-corner_m, corner_m);
  forest->trees_m = grow(spacing, density_per_ha, mapping.stems, side_m, seed);
  forest->near = std::make_unique<KdTree2>(forest->trees_m);
  map_trees(*forest, mapping, seed);
  return forest;
}

Pose2 draw_pose(const MappedForest& forest, double border_m, std::uint64_t seed,
                std::uint64_t query) {
  const Eigen::Vector2d low_m = forest.box_m.min().array() + border_m;
  const Eigen::Vector2d high_m = forest.box_m.max().array() - border_m;
  constexpr int kTries = 10000;
  RandomStream stream(seed, "sighting_pose", {query});
  for (int i = 0; i < kTries && (low_m.array() < high_m.array()).all(); ++i) {
    const double x_m = stream.uniform(low_m.x(), high_m.x());
    const Eigen::Vector2d place_m(x_m, stream.uniform(low_m.y(), high_m.y()));
    const double yaw_rad = wrap_to_pi(stream.uniform(-kPi, kPi));
    if (is_clear(forest, place_m)) return {place_m, yaw_rad};
  }
  throw UserError(
      "sighting.border_m leaves no place for the sensor in the forest; make it smaller, or give "
      "more stems (sighting.map.stems) or fewer a hectare (forest.density_per_ha)");
}

}  // namespace honka::sim
