#include <cmath>
#include <optional>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "sim/forest/forest.h"
#include "sim/forest/measured.h"

namespace honka::sim {
namespace {

/// Ground and stems that the spacing process has to reckon with.
SpacingDomain make_domain(const ForestSettings& settings, const Eigen::AlignedBox2d& box_m,
                          const std::vector<Polyline>& corridors,
                          const std::optional<MeasuredStand>& measured) {
  SpacingDomain domain;
  domain.box_m = box_m;
  domain.corridors = CorridorMask(corridors, settings.corridor_half_width_m, box_m);
  if (measured) domain.window_m = measured->window_m;
  const bool whole = domain.corridors.empty() && !measured;
  const double area_m2 = whole ? box_m.sizes().prod() : free_area_m2(domain);
  // A scenario's density counts its roads, as foresters do; a measured one counts none.
  const double counted_m2 = measured ? area_m2 : box_m.sizes().prod();
  const double density_per_ha = measured ? measured->density_per_ha : settings.density_per_ha;
  domain.count = std::llround(1e-4 * density_per_ha * counted_m2);
  if (domain.count > 0 && area_m2 < 0.05 * counted_m2) {
    throw UserError("forest: corridors leave no ground for trees; make them narrower or fewer");
  }
  domain.spacing_m =
      domain.count > 0 ? std::sqrt(area_m2 / static_cast<double>(domain.count)) : 1.0;
  return domain;
}

/// Adds trees at places, numbered on from those that stand.
void grow(const TreeSettings& trees, const StemMap& stems, std::uint64_t seed, Stand& stand) {
  for (const Stem& stem : stems) {
    const auto id = static_cast<std::int32_t>(stand.trees.size());
    const Eigen::Vector2d p = stem.position_m;
    stand.trees.push_back(
        grow_tree(trees, id, {p.x(), p.y(), stand.terrain.height_m(p)}, stem, seed));
  }
}

}  // namespace

Stand make_stand(const ForestSettings& settings, const std::vector<Polyline>& corridors,
                 std::uint64_t seed, const StemMap* measured) {
  check(settings);
  Stand stand;
  stand.extent_m = Eigen::AlignedBox2d(Eigen::Vector2d::Zero(),
                                       Eigen::Vector2d(settings.width_m, settings.length_m));
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(settings.margin_m);
  const Eigen::AlignedBox2d box_m(stand.extent_m.min() - margin, stand.extent_m.max() + margin);
  std::optional<MeasuredStand> plot;
  if (measured != nullptr) plot = centred(*measured, stand.extent_m);
  stand.terrain = make_terrain(settings.terrain, stand.extent_m, settings.margin_m, seed);

  // Measured stems first; a road through them has been cut.
  SpacingDomain domain = make_domain(settings, box_m, corridors, plot);
  const TreeSettings trees = plot ? fitted_to(settings.trees, plot->stems) : settings.trees;
  if (plot) {
    const auto cut = std::erase_if(
        plot->stems, [&](const Stem& stem) { return domain.corridors.contains(stem.position_m); });
    stand.removed_by_corridors = static_cast<std::int64_t>(cut);
    stand.measured_trees = static_cast<std::int64_t>(plot->stems.size());
    for (const Stem& stem : plot->stems) domain.fixed_m.push_back(stem.position_m);
    grow(trees, plot->stems, seed, stand);
  }

  // The generated stand around them.
  StemMap generated;
  for (const Eigen::Vector2d& place_m : place_stems(settings.spacing, domain, seed)) {
    generated.emplace_back().position_m = place_m;
  }
  grow(trees, generated, seed, stand);
  add_undergrowth(settings.undergrowth, box_m, corridors, settings.corridor_half_width_m, seed,
                  stand);
  return stand;
}

}  // namespace honka::sim
