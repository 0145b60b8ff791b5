#include "sim/forest/trees.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

constexpr int kLeastToFit = 5;  // fewer measured values say too little of a distribution

double draw_dbh_m(const TreeSettings& s, std::uint64_t id, std::uint64_t seed) {
  RandomStream stream(seed, "tree_dbh", {id});
  return std::max(s.dbh_min_m, stream.weibull(s.dbh_shape, s.dbh_scale_m));
}

double draw_height_m(const TreeSettings& s, double dbh_m, std::uint64_t id, std::uint64_t seed) {
  RandomStream stream(seed, "tree_height", {id});
  const double mean_m = naslund_height_m(s, dbh_m);
  // A residual must not fell a small tree: at least half the curve's height.
  return std::max(mean_m + stream.normal(0.0, s.height_residual_m), std::max(0.5 * mean_m, 2.0));
}

void fit_dbh(TreeSettings& s, const StemMap& stems) {
  double sum = 0.0, squares = 0.0;
  int n = 0;
  for (const Stem& stem : stems) {
    if (!stem.dbh_m) continue;
    sum += *stem.dbh_m;
    squares += *stem.dbh_m * *stem.dbh_m;
    ++n;
  }
  if (n < kLeastToFit) return;
  const double mean = sum / n;
  const double variance = std::max(0.0, (squares - n * mean * mean) / (n - 1));
  s.dbh_shape = weibull_shape_of_variation(std::sqrt(variance) / mean);
  s.dbh_scale_m = mean / std::tgamma(1.0 + 1.0 / s.dbh_shape);
}

/// Näslund's curve is linear in d / √(h − 1.3) = a + b d.
void fit_heights(TreeSettings& s, const StemMap& stems) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const Stem& stem : stems) {
    if (!stem.dbh_m || !stem.height_m || *stem.height_m <= 1.5) continue;
    const double x = 100.0 * *stem.dbh_m;
    const double y = x / std::sqrt(*stem.height_m - 1.3);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < kLeastToFit || spread <= 0.0) return;
  const double b = (n * sxy - sx * sy) / spread;
  const double a = (sy - b * sx) / n;
  if (a <= 0.0 || b <= 0.0) return;  // a curve that would not rise and level off
  s.naslund_a = a;
  s.naslund_b = b;
}

}  // namespace

void describe(SettingsVisitor& v, TreeSettings& s) {
  v.field({"dbh_shape", "", "Weibull shape of the diameters at breast height",
           "mature Scots pine: 3 to 4.5, middle"},
          s.dbh_shape, {0.5, 50.0});
  v.field({"dbh_scale_m", "m", "Weibull scale of the diameters at breast height",
           "mature Scots pine: 0.18 to 0.23 m, middle"},
          s.dbh_scale_m, {0.02, 2.0});
  v.field({"dbh_min_m", "m", "smaller diameters are raised to this", "choice: callipering limit"},
          s.dbh_min_m, {0.01, 1.0});
  v.field({"naslund_a", "", "height = 1.3 m + d² / (a + b d)², d in cm", "Naslund1936, Scots pine"},
          s.naslund_a, {0.01, 20.0});
  v.field({"naslund_b", "", "height = 1.3 m + d² / (a + b d)², d in cm", "Naslund1936, Scots pine"},
          s.naslund_b, {0.05, 2.0});
  v.field({"height_residual_m", "m", "standard deviation of heights about the curve",
           "Scots pine stands: about 2 m"},
          s.height_residual_m, {0.0, 10.0});
  v.field({"lean_sd_deg", "deg", "standard deviation of the lean, along x and along y",
           "standing pines: 1 to 2 degrees"},
          s.lean_sd_deg, {0.0, 20.0});
  v.field({"crown_base_low", "", "lowest share of the height at which the live crown begins",
           "mature Scots pine: 0.5"},
          s.crown_base_low, {0.0, 0.95});
  v.field({"crown_base_high", "", "highest share of the height at which the live crown begins",
           "mature Scots pine: 0.6"},
          s.crown_base_high, {0.0, 0.95});
  v.field({"spruce_share", "", "share of trees that are spruces", "choice: a pure pine stand"},
          s.spruce_share, {0.0, 1.0});
}

double naslund_height_m(const TreeSettings& settings, double dbh_m) {
  const double dbh_cm = 100.0 * dbh_m;
  const double root = dbh_cm / (settings.naslund_a + settings.naslund_b * dbh_cm);
  return 1.3 + root * root;
}

Tree grow_tree(const TreeSettings& settings, std::int32_t id, const Eigen::Vector3d& base_m,
               const Stem& known, std::uint64_t seed) {
  const auto key = static_cast<std::uint64_t>(id);
  Tree tree;
  tree.id = id;
  tree.base_m = base_m;
  tree.dbh_m = known.dbh_m.value_or(0.0);
  if (!known.dbh_m) tree.dbh_m = draw_dbh_m(settings, key, seed);
  tree.height_m = known.height_m.value_or(0.0);
  if (!known.height_m) tree.height_m = draw_height_m(settings, tree.dbh_m, key, seed);

  RandomStream form(seed, "tree_form", {key});
  const double lean_sd = std::tan(deg_to_rad(settings.lean_sd_deg));
  const double lean_x = form.normal(0.0, lean_sd);
  const double lean_y = form.normal(0.0, lean_sd);
  tree.lean = {lean_x, lean_y};
  tree.crown_base_m =
      tree.height_m * form.uniform(settings.crown_base_low, settings.crown_base_high);
  tree.species = form.uniform() < settings.spruce_share ? Species::kSpruce : Species::kPine;
  return tree;
}

double weibull_shape_of_variation(double variation) {
  const auto variation_of = [](double shape) {
    const double mean = std::tgamma(1.0 + 1.0 / shape);
    return std::sqrt(std::tgamma(1.0 + 2.0 / shape) / (mean * mean) - 1.0);
  };
  double low = 0.5, high = 50.0;  // the variation falls as the shape grows
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (variation_of(middle) > variation ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TreeSettings fitted_to(const TreeSettings& settings, const StemMap& stems) {
  TreeSettings fitted = settings;
  fit_dbh(fitted, stems);
  fit_heights(fitted, stems);
  return fitted;
}

}  // namespace honka::sim
