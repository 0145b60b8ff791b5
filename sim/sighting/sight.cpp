#include "sim/sighting/sight.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka::sim {
namespace {

struct SeenTree {
  std::int32_t tree = -1;
  Eigen::Vector2d place_in_sensor_m = Eigen::Vector2d::Zero();
  double distance_m = 0.0;
};

bool is_in_view(const Eigen::Vector2d& place_in_sensor_m, double field_of_view_deg) {
  return std::abs(std::atan2(place_in_sensor_m.y(), place_in_sensor_m.x())) <=
         0.5 * deg_to_rad(field_of_view_deg);
}

/// Standing trees in range and view that are not missed, nearest first. Whether a tree is missed
/// does not depend on the others.
std::vector<SeenTree> seen_trees(const MappedForest& forest, const Pose2& T_sensor_world,
                                 const Eigen::Vector2d& sensor_m, const SightingSettings& settings,
                                 std::uint64_t seed, std::uint64_t query) {
  std::vector<SeenTree> seen;
  for (const std::uint32_t tree : forest.near->within(sensor_m, settings.range_m)) {
    if (forest.standing[tree] == 0) continue;
    const Eigen::Vector2d place_m = T_sensor_world * forest.trees_m[tree];
    if (!is_in_view(place_m, settings.field_of_view_deg)) continue;
    RandomStream stream(seed, "sighting_missed", {query, tree});
    if (stream.uniform() < settings.missed_share) continue;
    seen.push_back({static_cast<std::int32_t>(tree), place_m, place_m.norm()});
  }
  std::sort(seen.begin(), seen.end(), [](const SeenTree& a, const SeenTree& b) {
    return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.tree < b.tree;
  });
  return seen;
}

/// How many of a list of true stems and false ones are true and false.
struct ListShares {
  std::size_t true_stems = 0, false_stems = 0;
};

ListShares shares_of(std::size_t seen, const SightingSettings& settings) {
  const auto rounded = [](double value) { return static_cast<std::size_t>(std::llround(value)); };
  const double per_true = settings.false_share / (1.0 - settings.false_share);
  ListShares shares{seen, rounded(per_true * static_cast<double>(seen))};
  const auto most = static_cast<std::size_t>(settings.most_stems);
  if (most != 0 && shares.true_stems + shares.false_stems > most) {
    shares.false_stems = rounded(settings.false_share * static_cast<double>(most));
    shares.true_stems = std::min(seen, most - shares.false_stems);
  }
  return shares;
}

Eigen::Vector2d measured(const SeenTree& seen, const SightingSettings& settings, std::uint64_t seed,
                         std::uint64_t query) {
  RandomStream stream(seed, "sighting_noise", {query, static_cast<std::uint64_t>(seen.tree)});
  // One after the other: the order of arguments is the compiler's.
  const double y_error_m = stream.normal(0.0, settings.noise_m);
  const double x_error_m = stream.normal(0.0, settings.noise_m);
  const Eigen::Vector2d error_m(x_error_m, y_error_m);
  const double scale = 1.0 - settings.radial_bias_m / std::max(seen.distance_m, 1e-9);
  return scale * seen.place_in_sensor_m + error_m;
}

/// Uniform over the area of the view up to `reach_m`.
Eigen::Vector2d false_stem(double reach_m, double field_of_view_deg, RandomStream& stream) {
  const double distance_m = reach_m * std::sqrt(stream.uniform());
  const double half_rad = 0.5 * deg_to_rad(field_of_view_deg);
  const double bearing_rad = stream.uniform(-half_rad, half_rad);
  return distance_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

}  // namespace

Sighting sight(const MappedForest& forest, const Pose2& T_world_sensor,
               const SightingSettings& settings, std::uint64_t seed, std::uint64_t query) {
  // True stems
  const auto seen = seen_trees(forest, T_world_sensor.inverse(), T_world_sensor.translation_m,
                               settings, seed, query);
  const ListShares shares = shares_of(seen.size(), settings);
  Sighting sighting;
  for (std::size_t i = 0; i < shares.true_stems; ++i) {
    sighting.stems_in_sensor_m.push_back(measured(seen[i], settings, seed, query));
    sighting.trees.push_back(seen[i].tree);
  }
  // False stems, where the list reaches
  const bool cut = shares.true_stems < seen.size() && shares.true_stems > 0;
  const double reach_m = cut ? seen[shares.true_stems - 1].distance_m : settings.range_m;
  RandomStream stream(seed, "sighting_false", {query});
  for (std::size_t i = 0; i < shares.false_stems; ++i) {
    sighting.stems_in_sensor_m.push_back(false_stem(reach_m, settings.field_of_view_deg, stream));
    sighting.trees.push_back(-1);
  }
  return sighting;
}

}  // namespace honka::sim
