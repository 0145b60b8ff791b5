#include "sim/forest/terrain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algo/types/angles.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// A plane wave of the random field.
struct Wave {
  Eigen::Vector2d per_m;  ///< radians per metre
  double phase_rad = 0.0, amplitude = 0.0;
};

/// Waves of lengths within a factor of two of the asked one, each way equally likely; the longer
/// the higher, so that the ground rolls and does not ripple.
std::vector<Wave> random_waves(double wavelength_m, RandomStream stream) {
  constexpr int kWaves = 24;
  std::vector<Wave> waves;
  for (int i = 0; i < kWaves; ++i) {
    const double length_m = wavelength_m * std::exp2(stream.uniform(-1.0, 1.0));
    const double heading_rad = stream.uniform(-kPi, kPi);
    Wave wave;
    wave.per_m =
        2.0 * kPi / length_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
    wave.phase_rad = stream.uniform(-kPi, kPi);
    wave.amplitude = length_m / wavelength_m;
    waves.push_back(wave);
  }
  return waves;
}

double field(const std::vector<Wave>& waves, const Eigen::Vector2d& position_m) {
  double sum = 0.0;
  for (const Wave& w : waves) {
    sum += w.amplitude * std::sin(w.per_m.dot(position_m) + w.phase_rad);
  }
  return sum;
}

/// Standard deviation of `field` over the plane.
double deviation(const std::vector<Wave>& waves) {
  double sum = 0.0;
  for (const Wave& w : waves) sum += 0.5 * w.amplitude * w.amplitude;
  return std::sqrt(sum);
}

/// Highest less lowest value of the field inside the site, on a 5 m grid.
double field_relief(const std::vector<Wave>& waves, const Eigen::AlignedBox2d& extent_m) {
  constexpr double kStep_m = 5.0;
  double low = field(waves, extent_m.center()), high = low;
  for (double y = extent_m.min().y(); y <= extent_m.max().y(); y += kStep_m) {
    for (double x = extent_m.min().x(); x <= extent_m.max().x(); x += kStep_m) {
      const double value = field(waves, {x, y});
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return high - low;
}

}  // namespace

void describe(SettingsVisitor& v, TerrainSettings& s) {
  v.field({"relief_m", "m", "highest less lowest ground of the rolling part inside the site",
           "Li2020: relief 8 m"},
          s.relief_m, {0.0, 200.0});
  v.field({"relief_wavelength_m", "m", "typical distance from hill to hill", "choice"},
          s.relief_wavelength_m, {5.0, 5000.0});
  v.field({"slope_deg", "deg", "slope of the whole site, added to the relief", "choice"},
          s.slope_deg, {0.0, 35.0});
  v.field({"slope_direction_deg", "deg", "uphill direction from x, counter-clockwise", "choice"},
          s.slope_direction_deg, {-360.0, 360.0});
  v.field({"micro_relief_m", "m", "standard deviation of hummocks and hollows",
           "choice: a few centimetres on a pine heath, more on peat or boulder soil"},
          s.micro_relief_m, {0.0, 1.0});
  v.field({"micro_wavelength_m", "m", "typical distance from hummock to hummock", "choice"},
          s.micro_wavelength_m, {0.5, 50.0});
  v.field({"cell_m", "m", "step of the height field", "choice"}, s.cell_m, {0.1, 10.0});
  v.field({"border_m", "m", "ground beyond the last trees", "choice"}, s.border_m, {1.0, 500.0});
}

Heightfield make_terrain(const TerrainSettings& settings, const Eigen::AlignedBox2d& extent_m,
                         double margin_m, std::uint64_t seed) {
  const double border_m = margin_m + settings.border_m;
  const Eigen::Vector2d origin_m = extent_m.min() - Eigen::Vector2d::Constant(border_m);
  const Eigen::Vector2d sizes_m = extent_m.sizes() + Eigen::Vector2d::Constant(2.0 * border_m);
  const int nx = static_cast<int>(std::ceil(sizes_m.x() / settings.cell_m)) + 1;
  const int ny = static_cast<int>(std::ceil(sizes_m.y() / settings.cell_m)) + 1;

  const auto hills =
      random_waves(settings.relief_wavelength_m, RandomStream(seed, "terrain_relief"));
  const auto hummocks =
      random_waves(settings.micro_wavelength_m, RandomStream(seed, "terrain_micro"));
  const double hill_scale = settings.relief_m / std::max(1e-9, field_relief(hills, extent_m));
  const double hummock_scale = settings.micro_relief_m / deviation(hummocks);
  const double heading_rad = deg_to_rad(settings.slope_direction_deg);
  const Eigen::Vector2d rise = std::tan(deg_to_rad(settings.slope_deg)) *
                               Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));

  std::vector<double> heights_m;
  heights_m.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (int iy = 0; iy < ny; ++iy) {
    for (int ix = 0; ix < nx; ++ix) {
      const Eigen::Vector2d p = origin_m + settings.cell_m * Eigen::Vector2d(ix, iy);
      heights_m.push_back(hill_scale * field(hills, p) + hummock_scale * field(hummocks, p) +
                          rise.dot(p - extent_m.center()));
    }
  }
  return {origin_m, settings.cell_m, nx, ny, std::move(heights_m)};
}

}  // namespace honka::sim
