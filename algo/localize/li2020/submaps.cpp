#include "algo/localize/li2020/submaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algo/types/user_error.h"

namespace honka {
namespace {

/// Whether `a` is the better answer of two tiles.
bool is_better_answer(const LocateResult& a, const LocateResult& b) {
  if (a.agreeing != b.agreeing) return a.agreeing > b.agreeing;
  if (a.matches == 0 || b.matches == 0) return a.matches > b.matches;
  return a.cost_m * b.matches < b.cost_m * a.matches;
}

/// Tiles along one side of the map.
int tiles_along(double length_m, double size_m, double step_m) {
  return 1 + std::max(0, static_cast<int>(std::ceil((length_m - size_m) / step_m)));
}

}  // namespace

template <int D>
SubmapMatcherIn<D>::SubmapMatcherIn(const StarPoints<D>& stems_in_map_m,
                                    const Li2020Settings& settings) {
  const double step_m = settings.submap_size_m - settings.submap_overlap_m;
  if (!(step_m > 0.0)) {
    throw UserError(
        fmt::format("li2020.submap_overlap_m is {} of tiles of {} m; give less than their size",
                    settings.submap_overlap_m, settings.submap_size_m));
  }
  Eigen::Vector2d low_m = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d high_m = -low_m;
  for (const StarPoint<D>& stem : stems_in_map_m) {
    if (!stem.allFinite()) throw UserError("the map has a stem that is not finite");
    low_m = low_m.cwiseMin(stem.template head<2>());
    high_m = high_m.cwiseMax(stem.template head<2>());
  }
  if (!stems_in_map_m.empty()) {
    const Eigen::Vector2d side_m = high_m - low_m;
    for (int iy = 0; iy < tiles_along(side_m.y(), settings.submap_size_m, step_m); ++iy) {
      for (int ix = 0; ix < tiles_along(side_m.x(), settings.submap_size_m, step_m); ++ix) {
        add_tile(stems_in_map_m, low_m + step_m * Eigen::Vector2d(ix, iy), settings);
      }
    }
  }
  if (tiles_.empty()) {
    throw UserError(
        fmt::format("no sub-map of the {} stems has a triangle with three neighbours; "
                    "give a map of more stems, or larger sub-maps",
                    stems_in_map_m.size()));
  }
}

template <int D>
void SubmapMatcherIn<D>::add_tile(const StarPoints<D>& stems_in_map_m, const Eigen::Vector2d& low_m,
                                  const Li2020Settings& settings) {
  Tile tile{low_m, low_m.array() + settings.submap_size_m, {}, nullptr};
  StarPoints<D> inside_m;
  for (std::size_t i = 0; i < stems_in_map_m.size(); ++i) {
    const Eigen::Array2d stem = stems_in_map_m[i].template head<2>();
    if ((stem < tile.low_m.array()).any() || (stem > tile.high_m.array()).any()) continue;
    inside_m.push_back(stems_in_map_m[i]);
    tile.stems.push_back(static_cast<std::int32_t>(i));
  }
  const StarGraph<D> graph = star_graph<D>(inside_m);
  if (stars_of(graph.delaunay, StarChoice::kThreeNeighbours).empty()) return;
  tile.matcher = std::make_unique<Li2020MatcherIn<D>>(inside_m, settings);
  tiles_.push_back(std::move(tile));
}

template <int D>
LocateResult SubmapMatcherIn<D>::locate(const StarPoints<D>& stems_in_local_m,
                                        const std::optional<LocatePrior>& prior) const {
  check_prior(prior);
  LocateResult best;
  const Tile* of_best = nullptr;
  for (const Tile& tile : tiles_) {
    if (prior) {
      const Eigen::Vector2d& p = prior->position_in_map_m;
      const Eigen::Vector2d nearest_m = p.cwiseMax(tile.low_m).cwiseMin(tile.high_m);
      if ((nearest_m - p).norm() > prior->radius_m) continue;
    }
    LocateResult answer = tile.matcher->locate(stems_in_local_m, prior);
    if (of_best != nullptr && !is_better_answer(answer, best)) continue;
    best = std::move(answer);
    of_best = &tile;
  }
  if (of_best == nullptr) {  // the prior lies beside the map
    best.stems = static_cast<int>(stems_in_local_m.size());
    best.verdict = Verdict::kNotInMap;
    return best;
  }
  for (StarMatch& match : best.star_matches) {
    for (VertexPair& pair : match.pairs) {
      pair.map = of_best->stems[static_cast<std::size_t>(pair.map)];
    }
  }
  return best;
}

template class SubmapMatcherIn<2>;
template class SubmapMatcherIn<3>;

}  // namespace honka
