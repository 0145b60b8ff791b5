#include "sim/forest/thinning.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "sim/forest/spacing/torus_grid.h"

namespace honka::sim {
namespace {

/// Whether a place lies on one of the parallel strip roads.
bool on_strip_road(const ThinningSettings& s, const Eigen::Vector2d& offset_m) {
  const double turn_rad = deg_to_rad(s.strip_road_direction_deg);
  const Eigen::Vector2d across(-std::sin(turn_rad), std::cos(turn_rad));
  const double from_road_m =
      std::remainder(across.dot(offset_m) - s.strip_road_offset_m, s.strip_road_spacing_m);
  return std::abs(from_road_m) < 0.5 * s.strip_road_width_m;
}

/// Trees that stand, by how much a forester would keep them.
class Choice {
 public:
  Choice(const Stand& stand, const std::vector<bool>& standing, const ThinningSettings& settings,
         std::uint64_t seed)
      : stand_(stand),
        standing_(standing),
        sd_(settings.judgement_sd),
        seed_(seed),
        box_m_(box_of(stand)),
        reach_m_(2.0 * std::sqrt(box_m_.volume() / static_cast<double>(stand.trees.size() + 1))),
        grid_(box_m_, reach_m_) {
    double sum_m = 0.0;
    for (const Tree& tree : stand.trees) {
      grid_.add(tree.base_m.head<2>());
      sum_m += tree.dbh_m;
    }
    mean_dbh_m_ = sum_m / static_cast<double>(std::max<std::size_t>(1, stand.trees.size()));
  }

  /// Low for small and crowded trees: relative DBH times the distance to the nearest neighbour.
  [[nodiscard]] double worth(std::size_t i) const {
    double nearest2 = reach_m_ * reach_m_;
    for_near(i, [&](std::size_t, double d2) { nearest2 = std::min(nearest2, d2); });
    RandomStream stream(seed_, "thinning", {static_cast<std::uint64_t>(stand_.trees[i].id)});
    const double judgement = std::exp(stream.normal(0.0, sd_));
    return stand_.trees[i].dbh_m / mean_dbh_m_ * std::sqrt(nearest2) * judgement;
  }

  /// Standing trees within the reach of tree i.
  template <typename Visit>
  void for_near(std::size_t i, const Visit& visit) const {
    const Eigen::Vector2d place_m = grid_.points_m()[i];
    grid_.near(place_m, [&](std::size_t j, double) {
      // Not around the border: a thinned forest ends where it ends.
      const double d2 = (place_m - grid_.points_m()[j]).squaredNorm();
      if (j != i && standing_[j] && d2 < reach_m_ * reach_m_) visit(j, d2);
    });
  }

 private:
  static Eigen::AlignedBox2d box_of(const Stand& stand) {
    Eigen::AlignedBox2d box_m = stand.extent_m;
    for (const Tree& tree : stand.trees) box_m.extend(tree.base_m.head<2>().eval());
    return box_m;
  }

  const Stand& stand_;
  const std::vector<bool>& standing_;
  double sd_ = 0.0, mean_dbh_m_ = 1.0;
  std::uint64_t seed_;
  Eigen::AlignedBox2d box_m_;
  double reach_m_;
  TorusGrid grid_;
};

/// Fells the tree of least worth, again and again, until `target` stand.
void fell_least_worth(const Choice& choice, std::size_t standing_count, std::size_t target,
                      std::vector<bool>& standing) {
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> worth(standing.size(), 0.0);
  const auto push = [&](std::size_t i) {
    worth[i] = choice.worth(i);
    queue.push({worth[i], i});
  };
  for (std::size_t i = 0; i < standing.size(); ++i) {
    if (standing[i]) push(i);
  }
  while (standing_count > target && !queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (!standing[i] || value != worth[i]) continue;  // felled, or weighed anew since
    standing[i] = false;
    --standing_count;
    choice.for_near(i, [&](std::size_t j, double) { push(j); });
  }
}

}  // namespace

void describe(SettingsVisitor& v, ThinningSettings& s) {
  v.field({"target_density_per_ha", "1/ha", "stems left", "Li2020: 8 m after the second thinning"},
          s.target_density_per_ha, {0.0, 20000.0});
  v.field({"strip_road_spacing_m", "m", "distance from strip road to strip road",
           "Nordic thinning practice: every 20 m"},
          s.strip_road_spacing_m, {5.0, 1000.0});
  v.field({"strip_road_width_m", "m", "width of a strip road", "Nordic practice: 4 to 4.5 m"},
          s.strip_road_width_m, {0.0, 20.0});
  v.field({"strip_road_direction_deg", "deg", "of the strip roads, from x", "choice"},
          s.strip_road_direction_deg, {-360.0, 360.0});
  v.field({"strip_road_offset_m", "m", "of one strip road from the middle of the site", "choice"},
          s.strip_road_offset_m, {-1000.0, 1000.0});
  v.field(
      {"judgement_sd", "", "spread of the driver's judgement (log of a tree's worth)", "choice"},
      s.judgement_sd, {0.0, 5.0});
  v.field({"stump_height_m", "m", "height of the stumps left", "choice: harvester cut"},
          s.stump_height_m, {0.02, 2.0});
}

Stand thin(const Stand& stand, const ThinningSettings& settings, std::uint64_t seed) {
  if (!(settings.strip_road_spacing_m > settings.strip_road_width_m)) {
    throw UserError(
        "thinning: strip roads leave no stand; strip_road_spacing_m must exceed "
        "strip_road_width_m");
  }
  std::vector<bool> standing;
  double inside = 0.0;
  for (const Tree& tree : stand.trees) {
    const Eigen::Vector2d place_m = tree.base_m.head<2>();
    standing.push_back(!on_strip_road(settings, place_m - stand.extent_m.center()));
    inside += stand.extent_m.contains(place_m) ? 1.0 : 0.0;
  }
  // The margin is thinned like the site: the same share of the trees is left.
  const double wanted = 1e-4 * settings.target_density_per_ha * stand.extent_m.sizes().prod();
  const double share = inside > 0.0 ? std::min(1.0, wanted / inside) : 1.0;
  const auto target =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(stand.trees.size())));
  const auto count = static_cast<std::size_t>(std::count(standing.begin(), standing.end(), true));
  fell_least_worth(Choice(stand, standing, settings, seed), count, target, standing);

  Stand thinned = stand;
  thinned.trees.clear();
  thinned.measured_trees = 0;
  for (std::size_t i = 0; i < stand.trees.size(); ++i) {
    const Tree& tree = stand.trees[i];
    if (standing[i]) {
      thinned.trees.push_back(tree);
      if (static_cast<std::int64_t>(i) < stand.measured_trees) ++thinned.measured_trees;
    } else {
      const double radius_m = stem_radius_m(tree, settings.stump_height_m);
      thinned.stumps.push_back({tree.base_m, radius_m, settings.stump_height_m, tree.id});
    }
  }
  return thinned;
}

}  // namespace honka::sim
