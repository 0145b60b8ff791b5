#include "sim/forest/undergrowth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "algo/types/angles.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// The ground on which things are strewn.
struct Ground {
  Eigen::AlignedBox2d box_m;
  CorridorMask corridors;
  const Heightfield* terrain = nullptr;

  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& p) const {
    return {p.x(), p.y(), terrain->height_m(p)};
  }
};

/// Poisson places at a density, each with a stream of its own; those in corridors are left out.
void strew(const Ground& ground, double per_ha, std::string_view name, std::uint64_t seed,
           const std::function<void(const Eigen::Vector3d&, RandomStream&)>& put) {
  const double area_ha = 1e-4 * ground.box_m.sizes().prod();
  const int count = RandomStream(seed, name).poisson(per_ha * area_ha);
  for (int i = 0; i < count; ++i) {
    RandomStream stream(seed, name, {static_cast<std::uint64_t>(i)});
    const double x = stream.uniform(ground.box_m.min().x(), ground.box_m.max().x());
    const double y = stream.uniform(ground.box_m.min().y(), ground.box_m.max().y());
    if (!ground.corridors.contains({x, y})) put(ground.at({x, y}), stream);
  }
}

Ellipsoid draw_rock(const Eigen::Vector3d& base_m, double radius_m, RandomStream& stream) {
  Ellipsoid rock;
  const double size_m = radius_m * stream.weibull(1.5, 1.0) + 0.1;
  const double a = size_m * stream.uniform(0.8, 1.3);
  const double b = size_m * stream.uniform(0.8, 1.3);
  rock.half_axes_m = {a, b, size_m * stream.uniform(0.6, 1.0)};
  rock.centre_m = base_m;  // half sunk
  rock.yaw_rad = stream.uniform(-kPi, kPi);
  rock.label = {-1, Part::kRock};
  return rock;
}

/// A pile of two to five logs, side by side, parallel to the corridor; none when an end would lie
/// in a corridor or outside the box.
void pile_logs(const Ground& ground, const Eigen::Vector2d& middle_m, const Eigen::Vector2d& along,
               RandomStream& stream, std::vector<Log>& logs) {
  const auto count = 2 + stream.below(4);
  const Eigen::Vector2d side(-along.y(), along.x());
  for (std::uint64_t i = 0; i < count; ++i) {
    // Sawlog and pulpwood lengths: 3 to 5.5 m.
    const double half_m = 0.5 * stream.uniform(3.0, 5.5);
    const double radius_m = stream.uniform(0.06, 0.14);
    const double taper = 0.005 * 2.0 * half_m;  // 1 cm of diameter per metre
    const double skew = stream.normal(0.0, 0.06);
    const Eigen::Vector2d heading = (along + skew * side).normalized();
    const Eigen::Vector2d centre = middle_m + (0.3 * static_cast<double>(i)) * side;
    const Eigen::Vector2d a = centre - half_m * heading, b = centre + half_m * heading;
    const auto blocked = [&](const Eigen::Vector2d& p) {
      return !ground.box_m.contains(p) || ground.corridors.contains(p);
    };
    if (blocked(a) || blocked(centre) || blocked(b)) continue;
    Log log;
    log.radius_a_m = radius_m;
    log.radius_b_m = std::max(0.03, radius_m - taper);
    log.a_m = ground.at(a) + Eigen::Vector3d(0, 0, log.radius_a_m);
    log.b_m = ground.at(b) + Eigen::Vector3d(0, 0, log.radius_b_m);
    logs.push_back(log);
  }
}

/// Piles at random places along one corridor, on either side.
void pile_along(const Ground& ground, const Polyline& line, std::uint64_t line_id, double per_100_m,
                double half_width_m, std::uint64_t seed, std::vector<Log>& logs) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d step = line[i] - line[i - 1];
    const double length_m = step.norm();
    if (length_m <= 0.0) continue;
    RandomStream stream(seed, "log_pile", {line_id, i});
    const int piles = stream.poisson(0.01 * length_m * per_100_m);
    const Eigen::Vector2d along = step / length_m, side(-along.y(), along.x());
    for (int k = 0; k < piles; ++k) {
      const Eigen::Vector2d on_line = line[i - 1] + stream.uniform() * step;
      const double sign = stream.uniform() < 0.5 ? -1.0 : 1.0;
      const double away_m = half_width_m + stream.uniform(0.4, 2.0);
      pile_logs(ground, on_line + sign * away_m * side, sign * along, stream, logs);
    }
  }
}

}  // namespace

void describe(SettingsVisitor& v, UndergrowthSettings& s) {
  constexpr std::string_view kLight =
      "choice: undergrowth is cleared before a mechanised thinning; what is left is light "
      "(a robustness study goes to 1,500 bushes and 300 saplings a hectare)";
  v.field({"bushes_per_ha", "1/ha", "shrubs and junipers", kLight}, s.bushes_per_ha, {0.0, 2e4});
  v.field({"bush_height_m", "m", "mean height of shrubs", "choice"}, s.bush_height_m, {0.1, 5.0});
  v.field({"saplings_per_ha", "1/ha", "young trees under the stand", kLight}, s.saplings_per_ha,
          {0.0, 2e4});
  v.field({"sapling_height_m", "m", "mean height of saplings", "choice"}, s.sapling_height_m,
          {0.2, 8.0});
  v.field({"rocks_per_ha", "1/ha", "rocks, half sunk", "choice: moraine soil"}, s.rocks_per_ha,
          {0.0, 5000.0});
  v.field({"rock_radius_m", "m", "typical radius of a rock", "choice"}, s.rock_radius_m,
          {0.05, 5.0});
  v.field({"stumps_per_ha", "1/ha", "stumps of earlier thinnings",
           "choice: what stands after a first thinning has lost about as many as a half to "
           "two thirds of it"},
          s.stumps_per_ha, {0.0, 5000.0});
  v.field({"stump_height_m", "m", "mean height of stumps", "choice: harvester cut, 0.1 to 0.3 m"},
          s.stump_height_m, {0.05, 2.0});
  v.field({"log_piles_per_100_m", "1/100 m", "piles of felled stems beside each corridor",
           "choice: the harvester lays its logs beside the strip road"},
          s.log_piles_per_100_m, {0.0, 100.0});
}

void add_undergrowth(const UndergrowthSettings& settings, const Eigen::AlignedBox2d& box_m,
                     const std::vector<Polyline>& corridors, double corridor_half_width_m,
                     std::uint64_t seed, Stand& stand) {
  const Ground ground{box_m, CorridorMask(corridors, corridor_half_width_m, box_m), &stand.terrain};
  strew(ground, settings.bushes_per_ha, "bush", seed, [&](const auto& base_m, auto& stream) {
    const double height_m = settings.bush_height_m * stream.uniform(0.5, 1.5);
    stand.bushes.push_back({base_m, height_m * stream.uniform(0.4, 0.8), height_m});
  });
  strew(ground, settings.saplings_per_ha, "sapling", seed, [&](const auto& base_m, auto& stream) {
    stand.saplings.push_back({base_m, settings.sapling_height_m * stream.uniform(0.4, 1.6)});
  });
  strew(ground, settings.rocks_per_ha, "rock", seed, [&](const auto& base_m, auto& stream) {
    stand.rocks.push_back(draw_rock(base_m, settings.rock_radius_m, stream));
  });
  strew(ground, settings.stumps_per_ha, "stump", seed, [&](const auto& base_m, auto& stream) {
    const double radius_m = stream.uniform(0.06, 0.14);
    stand.stumps.push_back({base_m, radius_m, settings.stump_height_m * stream.uniform(0.6, 1.4)});
  });
  for (std::size_t i = 0; i < corridors.size(); ++i) {
    pile_along(ground, corridors[i], i, settings.log_piles_per_100_m, corridor_half_width_m, seed,
               stand.logs);
  }
}

}  // namespace honka::sim
