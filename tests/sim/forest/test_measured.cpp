#include <catch2/catch.hpp>
#include <limits>

#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "sim/forest/forest.h"
#include "sim/forest/measured.h"
#include "sim/forest/spatial_statistics.h"
#include "tests/sim/forest/real_plots.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

/// 200 stems on 50 m × 40 m at UTM-like coordinates, DBH Weibull(5, 0.3 m).
honka::StemMap made_plot() {
  honka::StemMap stems;
  honka::RandomStream stream(3, "plot");
  for (int i = 0; i < 200; ++i) {
    auto& stem = stems.emplace_back();
    const double x = 668000.0 + stream.uniform(0, 50);
    stem.position_m = {x, 6950000.0 + stream.uniform(0, 40)};
    stem.dbh_m = stream.weibull(5.0, 0.3);
  }
  stems[7].height_m = 21.5;
  return stems;
}

double mean_dbh_m(const Stand& stand, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) sum += stand.trees[i].dbh_m;
  return sum / static_cast<double>(to - from);
}

}  // namespace

TEST_CASE("a measured stand stands at the centre as it was measured") {
  const honka::StemMap stems = made_plot();
  const Stand stand = make_stand({}, {}, 1, &stems);
  REQUIRE(stand.measured_trees == 200);
  CHECK(stand.removed_by_corridors == 0);
  const Vector2d shift = stand.trees[0].base_m.head<2>() - stems[0].position_m;
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < 200; ++i) {
    const Vector2d place = stand.trees[i].base_m.head<2>();
    box.extend(place);
    CHECK((place - stems[i].position_m - shift).norm() < 1e-8);
    CHECK(stand.trees[i].dbh_m == *stems[i].dbh_m);
  }
  CHECK(stand.trees[7].height_m == 21.5);
  CHECK((box.center() - stand.extent_m.center()).norm() < 1e-6);
}

TEST_CASE("the forest around a measured stand is like it and stays out of it") {
  const honka::StemMap stems = made_plot();
  const Stand stand = make_stand({}, {}, 1, &stems);
  const auto window = centred(stems, stand.extent_m).window_m;
  const double outside_ha = 1e-4 * (stand.extent_m.volume() - window.volume());
  const double density = static_cast<double>(stand.trees.size() - 200) / outside_ha;
  CHECK(density == Approx(1000.0).epsilon(0.05));
  CHECK(mean_dbh_m(stand, 200, stand.trees.size()) ==
        Approx(mean_dbh_m(stand, 0, 200)).epsilon(0.03));
  for (std::size_t i = 200; i < stand.trees.size(); ++i) {
    CHECK_FALSE(window.contains(stand.trees[i].base_m.head<2>().eval()));
  }
}

TEST_CASE("a road through a measured stand fells the trees on it and counts them") {
  const honka::StemMap stems = made_plot();
  const std::vector<Polyline> road = {{{100, 0}, {100, 300}}};
  const Stand stand = make_stand({}, road, 1, &stems);
  CHECK(stand.removed_by_corridors > 5);
  CHECK(stand.removed_by_corridors + stand.measured_trees == 200);
  for (const Tree& tree : stand.trees) CHECK(std::abs(tree.base_m.x() - 100.0) >= 2.25);
}

TEST_CASE("a stem map that is no stand is refused") {
  const auto refuses = [](honka::StemMap stems, const char* words) {
    CHECK_THROWS_WITH(make_stand({}, {}, 1, &stems), Catch::Contains(words));
  };
  honka::StemMap stems = made_plot();
  refuses({}, "too few");
  refuses({stems[0], stems[1]}, "too few");
  stems[4].position_m.x() = std::numeric_limits<double>::quiet_NaN();
  refuses(stems, "stem 5");
  stems = made_plot();
  stems[9].dbh_m = -0.1;
  refuses(stems, "stem 10");
  stems = made_plot();
  stems[0].position_m.x() += 1000.0;
  refuses(stems, "larger than the site");
  for (auto& stem : stems) stem.position_m.y() = 0.0;
  refuses(stems, "one line");
}

TEST_CASE("Weibull and Naslund are recovered from what was measured") {
  TreeSettings truth;
  truth.dbh_shape = 4.5;
  truth.dbh_scale_m = 0.25;
  truth.naslund_a = 1.1;
  truth.naslund_b = 0.21;
  honka::StemMap stems;
  honka::RandomStream stream(1, "fit");
  for (int i = 0; i < 4000; ++i) {
    auto& stem = stems.emplace_back();
    stem.dbh_m = stream.weibull(4.5, 0.25);
    if (i % 10 == 0) stem.height_m = naslund_height_m(truth, *stem.dbh_m);
  }
  const TreeSettings fitted = fitted_to({}, stems);
  CHECK(fitted.dbh_shape == Approx(4.5).epsilon(0.05));
  CHECK(fitted.dbh_scale_m == Approx(0.25).epsilon(0.02));
  CHECK(fitted.naslund_a == Approx(1.1).epsilon(1e-6));
  CHECK(fitted.naslund_b == Approx(0.21).epsilon(1e-6));
  CHECK(fitted_to({}, {}).dbh_shape == TreeSettings{}.dbh_shape);
}

TEST_CASE("every real plot continues into a stand of its own density") {
  const auto plots = honka::testing::ilomantsi_plots();
  if (plots.empty()) {
    WARN("skipped: no measured stem maps beside the source tree");
    return;
  }
  ForestSettings settings;
  settings.width_m = settings.length_m = 120.0;
  for (const auto& plot : plots) {
    CAPTURE(plot.name);
    const Stand stand = make_stand(settings, {}, 1, &plot.stems);
    const double real_per_ha =
        1e4 * static_cast<double>(plot.stems.size()) / plot.window_m.volume();
    CHECK(stand.measured_trees == static_cast<std::int64_t>(plot.stems.size()));
    CHECK(static_cast<double>(stand.trees.size()) == Approx(1.44 * real_per_ha).epsilon(0.06));
  }
}
