#include <catch2/catch.hpp>

#include "sim/forest/taper.h"

using namespace honka::sim;

namespace {

Tree pine_20_cm_18_m() {
  Tree tree;
  tree.id = 0;
  tree.dbh_m = 0.2;
  tree.height_m = 18.0;
  return tree;
}

}  // namespace

TEST_CASE("the taper ratio is 1 at a fifth of the height", "[Laasasenaho1982]") {
  CHECK(taper_ratio(Species::kPine, 0.8) == Approx(1.0).margin(5e-5));
  CHECK(taper_ratio(Species::kSpruce, 0.8) == Approx(1.0).margin(5e-5));
  CHECK(taper_ratio(Species::kPine, 0.0) == 0.0);
}

TEST_CASE("a pine of 20 cm and 18 m has the published diameters and volume", "[Laasasenaho1982]") {
  const Tree tree = pine_20_cm_18_m();
  CHECK(2.0 * stem_radius_m(tree, 0.0) == Approx(0.289).margin(5e-4));
  CHECK(2.0 * stem_radius_m(tree, 1.3) == Approx(0.2).margin(1e-12));
  CHECK(2.0 * stem_radius_m(tree, 8.0) == Approx(0.144).margin(5e-4));
  CHECK(stem_volume_m3(tree) == Approx(0.272).margin(5e-4));
}

TEST_CASE("stems get thinner with height and end at the top") {
  for (const Species species : {Species::kPine, Species::kSpruce}) {
    for (const double height_m : {3.0, 10.0, 18.0, 30.0}) {
      Tree tree = pine_20_cm_18_m();
      tree.species = species;
      tree.height_m = height_m;
      for (double h = 0.1; h < height_m; h += 0.1) {
        CHECK(stem_radius_m(tree, h) < stem_radius_m(tree, h - 0.1) + 1e-9);
      }
      CHECK(stem_radius_m(tree, height_m) == 0.0);
      CHECK(stem_radius_m(tree, height_m + 1.0) == 0.0);
      CHECK(stem_radius_m(tree, -0.5) == Approx(stem_radius_m(tree, 0.0)));
    }
  }
}

TEST_CASE("a leaning stem's centre moves with height") {
  Tree tree = pine_20_cm_18_m();
  tree.base_m = {3.0, 4.0, 5.0};
  tree.lean = {0.1, -0.2};
  CHECK(stem_centre_m(tree, 0.0) == Eigen::Vector2d(3.0, 4.0));
  CHECK(stem_centre_m(tree, 10.0).isApprox(Eigen::Vector2d(4.0, 2.0)));
}
