#include "sim/forest/taper.h"

#include <algorithm>
#include <array>

#include "algo/types/angles.h"
#include "algo/types/check.h"

namespace honka::sim {
namespace {

constexpr double kBreastHeight_m = 1.3;
using Coefficients = std::array<double, 8>;
// Laasasenaho 1982, Commun. Inst. For. Fenn. 108.
constexpr Coefficients kPine = {2.1288,  -0.63157, -1.6082, 2.4886,
                                -2.4147, 2.3619,   -1.7539, 1.0817};
constexpr Coefficients kSpruce = {2.3366, -3.2684, 3.6513, -2.2608, 0.0, 2.1501, -2.7412, 1.8876};
constexpr std::array<int, 8> kPowers = {1, 2, 3, 5, 8, 13, 21, 34};

}  // namespace

double taper_ratio(Species species, double x) {
  const Coefficients& c = species == Species::kPine ? kPine : kSpruce;
  double sum = 0.0, power = 1.0;
  int reached = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (; reached < kPowers[i]; ++reached) power *= x;
    sum += c[i] * power;
  }
  return sum;
}

Eigen::Vector2d stem_centre_m(const Tree& tree, double height_above_ground_m) {
  return tree.base_m.head<2>() + height_above_ground_m * tree.lean;
}

double stem_radius_m(const Tree& tree, double height_above_ground_m) {
  HONKA_CHECK(tree.height_m > kBreastHeight_m, "a tree reaches above breast height");
  const double x = 1.0 - height_above_ground_m / tree.height_m;
  if (x <= 0.0) return 0.0;
  const double at_breast = taper_ratio(tree.species, 1.0 - kBreastHeight_m / tree.height_m);
  // Scaled so that the diameter at 1.3 m is the DBH; below the ground as at the ground.
  return 0.5 * tree.dbh_m * taper_ratio(tree.species, std::min(x, 1.0)) / at_breast;
}

double stem_volume_m3(const Tree& tree) {
  constexpr int kSlices = 1000;
  const double step = tree.height_m / kSlices;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double radius = stem_radius_m(tree, (i + 0.5) * step);
    sum += kPi * radius * radius * step;
  }
  return sum;
}

}  // namespace honka::sim
