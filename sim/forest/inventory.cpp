#include "sim/forest/inventory.h"

#include "algo/geometry/kdtree.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

constexpr double kBreastHeight_m = 1.3;

Eigen::Vector2d isotropic_error(RandomStream& random, double sd_m) {
  const double x = random.normal(0.0, sd_m);
  const double y = random.normal(0.0, sd_m);
  return {x, y};
}

std::uint64_t identity_of(const Tree& tree) { return static_cast<std::uint64_t>(tree.id); }

/// Where the crown ends, without the error of a scan.
Eigen::Vector2d apex_m(const Tree& tree, const AirborneSettings& settings, std::uint64_t seed) {
  RandomStream random(seed, "crown_asymmetry", {identity_of(tree)});
  const double crown_radius_m = settings.crown_radius_share * tree.height_m;
  return stem_centre_m(tree, tree.height_m) +
         isotropic_error(random, settings.asymmetry_share * crown_radius_m);
}

/// Whether a taller neighbour's crown stands over the top of tree `i`.
bool is_overtopped(const std::vector<Tree>& trees, const std::vector<Eigen::Vector2d>& apexes_m,
                   const KdTree2& near, double reach_m, std::size_t i,
                   const AirborneSettings& settings) {
  for (const std::uint32_t other : near.within(apexes_m[i], reach_m)) {
    const Tree& neighbour = trees[other];
    if (neighbour.height_m < trees[i].height_m + settings.overtopped_by_m) continue;
    const double radius_m = settings.crown_radius_share * neighbour.height_m;
    if (other != i && (apexes_m[other] - apexes_m[i]).norm() < radius_m) return true;
  }
  return false;
}

}  // namespace

void describe(SettingsVisitor& v, InventorySettings& s) {
  v.field({"least_dbh_m", "m", "thinner stems are not measured",
           "choice: field plots tally stems from 5 to 10 cm on"},
          s.least_dbh_m, {0.0, 1.0});
  v.field({"position_error_m", "m", "s.d. of x and of y of a measured stem",
           "choice: tachymeter or tape from a known point"},
          s.position_error_m, {0.0, 10.0});
  v.field({"missed_share", "", "of the stems above the limit that are not in the list", "choice"},
          s.missed_share, {0.0, 1.0});
}

void describe(SettingsVisitor& v, AirborneSettings& s) {
  v.field({"position_error_m", "m", "s.d. of x and of y of a tree top",
           "0.5 to 1 m: airborne single-tree detection"},
          s.position_error_m, {0.0, 10.0});
  v.field({"asymmetry_share", "",
           "s.d. of a top's offset from its stem's axis, x and y each, over "
           "the crown's radius",
           "choice"},
          s.asymmetry_share, {0.0, 2.0});
  v.field({"crown_radius_share", "", "crown radius over the tree's height", "as forest.crown"},
          s.crown_radius_share, {0.01, 0.5});
  v.field({"overtopped_by_m", "m", "a neighbour is taller when it is so by this", "choice"},
          s.overtopped_by_m, {0.0, 50.0});
  v.field({"least_height_m", "m", "lower trees are not seen", "choice"}, s.least_height_m,
          {0.0, 100.0});
}

StemMap inventory_map(const Stand& stand, const InventorySettings& settings, std::uint64_t seed) {
  StemMap map;
  for (const Tree& tree : stand.trees) {
    RandomStream random(seed, "inventory", {identity_of(tree)});
    const bool missed = random.uniform() < settings.missed_share;
    const Eigen::Vector2d error_m = isotropic_error(random, settings.position_error_m);
    if (missed || tree.dbh_m < settings.least_dbh_m) continue;
    Stem stem;
    stem.position_m = stem_centre_m(tree, kBreastHeight_m) + error_m;
    stem.z_m = tree.base_m.z();
    stem.dbh_m = tree.dbh_m;
    stem.height_m = tree.height_m;
    map.push_back(stem);
  }
  return map;
}

StemMap airborne_map(const Stand& stand, const AirborneSettings& settings, std::uint64_t seed) {
  StemMap map;
  if (stand.trees.empty()) return map;
  std::vector<Eigen::Vector2d> apexes_m;
  double tallest_m = 0.0;
  for (const Tree& tree : stand.trees) {
    apexes_m.push_back(apex_m(tree, settings, seed));
    tallest_m = std::max(tallest_m, tree.height_m);
  }
  const KdTree2 near(apexes_m);
  const double reach_m = settings.crown_radius_share * tallest_m;
  for (std::size_t i = 0; i < stand.trees.size(); ++i) {
    const Tree& tree = stand.trees[i];
    if (tree.height_m < settings.least_height_m) continue;
    if (is_overtopped(stand.trees, apexes_m, near, reach_m, i, settings)) continue;
    RandomStream random(seed, "airborne", {identity_of(tree)});
    Stem stem;
    stem.position_m = apexes_m[i] + isotropic_error(random, settings.position_error_m);
    stem.z_m = stand.terrain.height_m(stem.position_m);
    stem.height_m = tree.height_m;
    map.push_back(stem);
  }
  return map;
}

}  // namespace honka::sim
