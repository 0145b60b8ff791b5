#include <catch2/catch.hpp>

#include "algo/types/angles.h"
#include "sim/forest/terrain.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

const Eigen::AlignedBox2d kSite(Vector2d(0, 0), Vector2d(200, 300));

/// Highest less lowest ground inside the site.
double relief_m(const Heightfield& terrain) {
  double low = 1e9, high = -1e9;
  for (int y = 0; y <= 300; ++y) {
    for (int x = 0; x <= 200; ++x) {
      const double z = terrain.height_m({x, y});
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  return high - low;
}

}  // namespace

TEST_CASE("hills have the asked relief inside the site") {
  TerrainSettings settings;
  settings.micro_relief_m = 0.0;
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    CHECK(relief_m(make_terrain(settings, kSite, 0.0, seed)) == Approx(8.0).epsilon(0.02));
  }
  settings.relief_m = 0.0;
  CHECK(relief_m(make_terrain(settings, kSite, 0.0, 1)) == Approx(0.0).margin(1e-12));
}

TEST_CASE("a slope rises in its direction") {
  TerrainSettings settings;
  settings.relief_m = settings.micro_relief_m = 0.0;
  settings.slope_deg = 10.0;
  settings.slope_direction_deg = 0.0;
  const Heightfield terrain = make_terrain(settings, kSite, 0.0, 1);
  const double rise = terrain.height_m({150, 100}) - terrain.height_m({50, 100});
  CHECK(rise == Approx(100.0 * std::tan(honka::deg_to_rad(10.0))));
  CHECK(terrain.height_m({70, 10}) == Approx(terrain.height_m({70, 290})));
}

TEST_CASE("micro-relief has the asked standard deviation") {
  TerrainSettings settings;
  settings.relief_m = 0.0;
  settings.micro_relief_m = 0.1;
  const Heightfield terrain = make_terrain(settings, kSite, 0.0, 5);
  double sum = 0, squares = 0, n = 0;
  for (int y = 0; y <= 300; ++y) {
    for (int x = 0; x <= 200; ++x) {
      const double z = terrain.height_m({x, y});
      sum += z, squares += z * z, n += 1;
    }
  }
  CHECK(std::sqrt(squares / n - sum * sum / n / n) == Approx(0.1).epsilon(0.05));
}

TEST_CASE("ground goes on beyond the site, and a seed fixes its digits") {
  const TerrainSettings settings;
  const Heightfield a = make_terrain(settings, kSite, 10.0, 1);
  const Heightfield b = make_terrain(settings, kSite, 10.0, 1);
  const Heightfield c = make_terrain(settings, kSite, 10.0, 2);
  CHECK(a.height_m({-39, -39}) != a.height_m({-35, -35}));
  CHECK(a.height_m({17.3, 211.9}) == b.height_m({17.3, 211.9}));
  CHECK(a.height_m({17.3, 211.9}) != c.height_m({17.3, 211.9}));
}
