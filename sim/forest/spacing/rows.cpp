#include "sim/forest/spacing/rows.h"

#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/user_error.h"

namespace honka::sim {
namespace {

/// Jittered lattice nodes on free ground. The jitter belongs to the node, not to the call.
Points free_nodes(const SpacingDomain& domain, const Rows& rows, double step_m,
                  std::uint64_t seed) {
  const Eigen::Rotation2Dd turn(deg_to_rad(rows.direction_deg));
  const double row_m = step_m * rows.row_ratio;
  const double reach_m = 0.5 * domain.box_m.sizes().norm();
  const int nx = static_cast<int>(reach_m / step_m) + 1;
  const int ny = static_cast<int>(reach_m / row_m) + 1;
  Points nodes;
  for (int y = -ny; y <= ny; ++y) {
    for (int x = -nx; x <= nx; ++x) {
      RandomStream stream(seed, "rows_jitter",
                          {static_cast<std::uint64_t>(x + nx), static_cast<std::uint64_t>(y + ny)});
      const double dx = stream.normal(0.0, rows.jitter * step_m);
      const double dy = stream.normal(0.0, rows.jitter * step_m);
      const Eigen::Vector2d node(x * step_m + dx, y * row_m + dy);
      const Eigen::Vector2d place_m = domain.box_m.center() + turn * node;
      if (domain.is_free(place_m)) nodes.push_back(place_m);
    }
  }
  return nodes;
}

}  // namespace

void describe(SettingsVisitor& v, Rows& s) {
  v.field({"row_ratio", "", "distance of rows over distance within a row",
           "choice: planted 2.5 m by 2 m"},
          s.row_ratio, {0.2, 5.0});
  v.field({"jitter", "", "standard deviation of a place over the distance within a row", "choice"},
          s.jitter, {0.0, 1.0});
  v.field({"survival", "", "share of planted places where a tree stands", "choice"}, s.survival,
          {0.05, 1.0});
  v.field({"direction_deg", "deg", "direction of the rows from x, counter-clockwise", "choice"},
          s.direction_deg, {-360.0, 360.0});
}

Points Rows::place(const SpacingDomain& domain, RandomStream& stream) const {
  const std::uint64_t seed = stream.bits64();
  double step_m = domain.spacing_m * std::sqrt(survival / row_ratio);
  Points nodes = free_nodes(domain, *this, step_m, seed);
  constexpr int kTries = 300;  // down to a fifth of the asked spacing
  for (int i = 0; static_cast<std::int64_t>(nodes.size()) < domain.count; ++i) {
    if (i == kTries) {
      throw UserError(
          "forest.spacing.rows: the rows have no room at this density; lower "
          "forest.density_per_ha or narrow the corridors");
    }
    step_m *= 0.995;  // borders may have cost a few places: plant a little closer
    nodes = free_nodes(domain, *this, step_m, seed);
  }
  // The first `count` of a random order survive (Fisher–Yates).
  const auto count = static_cast<std::size_t>(domain.count);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(nodes[i], nodes[i + stream.below(nodes.size() - i)]);
  }
  nodes.resize(count);
  return nodes;
}

}  // namespace honka::sim
