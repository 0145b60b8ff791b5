#include "algo/slam/methods/stem_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/geometry/cell_index.h"
#include "algo/slam/registration/nearest_stems.h"
#include "algo/types/check.h"

namespace honka {
namespace {

using Places = std::vector<Eigen::Vector3d>;

/// Side of the cells that the density of points is read from: some standard deviations wide.
constexpr double kDensityCell_m = 0.2;
/// Beyond any map: such places have no cell.
constexpr double kFarthest_m = 1e7;
/// Assign and average: what moves after that is far below the noise.
constexpr int kMeanRounds = 2;

/// Places of all points of all frames, and which points they are.
struct LaidPoints {
  Places places_m;
  std::vector<StemObservation> points;
};

LaidPoints lay_into_map(std::span<const SparseFrame> frames, const FramePoses& T_first_frame) {
  LaidPoints laid;
  for (std::uint32_t l = 0; l < frames.size(); ++l) {
    for (std::uint32_t k = 0; k < frames[l].points_m.size(); ++k) {
      const Eigen::Vector3d place_m = T_first_frame[l] * frames[l].points_m[k];
      if (!(place_m.array().abs() < kFarthest_m).all()) continue;
      laid.places_m.push_back(place_m);
      laid.points.push_back({l, k, 0});
    }
  }
  return laid;
}

/// Points counted in cells of the plane, and looked at nine cells at a time.
class PointDensity {
 public:
  explicit PointDensity(const Places& places_m)
      : planar_m_(planar_places(places_m)), lattice_(planar_m_, kDensityCell_m), cells_(keys()) {
    sums_.resize(cells_.cell_count(), Eigen::Vector4d::Zero());
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      sums_[cells_.cell_of(i)] += places_m[i].homogeneous();
    }
  }

  [[nodiscard]] std::size_t cells() const { return sums_.size(); }

  /// Sum of x, y, z and 1 over the points in the nine cells about a cell.
  [[nodiscard]] Eigen::Vector4d around(std::size_t cell) const {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for_cells_about(cell, 1, [&](std::uint32_t other) { sum += sums_[other]; });
    return sum;
  }

  /// Calls `visit` with every occupied cell up to `reach` cells away along each axis.
  template <class Visit>
  void for_cells_about(std::size_t cell, int reach, Visit visit) const {
    for (int dx = -reach; dx <= reach; ++dx) {
      for (int dy = -reach; dy <= reach; ++dy) {
        const auto other = cells_.find(cells_.key(cell) + CellLattice<2>::step({dx, dy}));
        if (other) visit(*other);
      }
    }
  }

 private:
  static std::vector<Eigen::Vector2d> planar_places(const Places& places_m) {
    std::vector<Eigen::Vector2d> planar_m;
    planar_m.reserve(places_m.size());
    for (const Eigen::Vector3d& place : places_m) planar_m.push_back(place.head<2>());
    return planar_m;
  }
  [[nodiscard]] std::vector<std::uint64_t> keys() const {
    std::vector<std::uint64_t> result;
    result.reserve(planar_m_.size());
    for (const Eigen::Vector2d& place : planar_m_) result.push_back(lattice_.key(place));
    return result;
  }

  std::vector<Eigen::Vector2d> planar_m_;
  CellLattice<2> lattice_;
  CellIndex cells_;
  std::vector<Eigen::Vector4d> sums_;
};

/// Centres of the densest places, none nearer than the gate to a denser one.
Places densest_places(const Places& places_m, const StemMapSettings& settings) {
  const PointDensity density(places_m);
  std::vector<Eigen::Vector4d> sums(density.cells());
  for (std::size_t c = 0; c < sums.size(); ++c) sums[c] = density.around(c);
  std::vector<std::uint32_t> order(sums.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sums[a].w() > sums[b].w(); });

  // Keys hold steps of at most kMargin cells, so wider gates are looked at less far.
  const int reach = std::min(static_cast<int>(std::ceil(settings.gate_m / kDensityCell_m)),
                             CellLattice<2>::kMargin);
  std::vector<std::uint8_t> taken(sums.size(), 0);
  Places centres_m;
  for (const std::uint32_t cell : order) {
    if (sums[cell].w() < static_cast<double>(settings.min_observations)) break;
    if (taken[cell] != 0) continue;
    centres_m.emplace_back(sums[cell].head<3>() / sums[cell].w());
    density.for_cells_about(cell, reach, [&](std::uint32_t other) { taken[other] = 1; });
  }
  return centres_m;
}

/// Each frame's nearest point to each centre within the gate. By frame, then by point.
std::vector<StemObservation> assign(const LaidPoints& laid, const Places& centres_m,
                                    double gate_m) {
  const NearestStems search(centres_m);
  std::vector<StemObservation> kept;
  std::vector<std::size_t> last(centres_m.size(), 0);  // where a stem's observation stands, + 1
  std::vector<double> distance_m2;
  for (std::size_t i = 0; i < laid.points.size(); ++i) {
    const NearestStem found = search.nearest_planar(laid.places_m[i].head<2>());
    if (found.index < 0 || !(found.squared_m2 < gate_m * gate_m)) continue;
    const auto stem = static_cast<std::uint32_t>(found.index);
    StemObservation seen = laid.points[i];
    seen.stem = stem;
    const bool again = last[stem] > 0 && kept[last[stem] - 1].frame == seen.frame;
    if (again && found.squared_m2 >= distance_m2[last[stem] - 1]) continue;
    if (again) kept[last[stem] - 1].stem = static_cast<std::uint32_t>(centres_m.size());
    kept.push_back(seen);
    distance_m2.push_back(found.squared_m2);
    last[stem] = kept.size();
  }
  std::erase_if(kept, [&](const StemObservation& o) { return o.stem >= centres_m.size(); });
  return kept;
}

/// Means, counts and scatter of what was assigned to each of `count` stems.
std::vector<MapStem> average(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
                             const std::vector<StemObservation>& observations, std::size_t count) {
  std::vector<MapStem> stems(count);
  for (const StemObservation& o : observations) {
    stems[o.stem].position_in_first_m += T_first_frame[o.frame] * frames[o.frame].points_m[o.point];
    ++stems[o.stem].observations;
  }
  for (MapStem& stem : stems) {
    if (stem.observations > 0) stem.position_in_first_m /= stem.observations;
  }
  return stems;
}

/// Drops stems with too few observations and numbers the rest anew.
void drop_few(StemMap3& map, std::int64_t min_observations) {
  std::vector<std::uint32_t> number(map.stems.size());
  std::vector<MapStem> stems;
  for (std::size_t s = 0; s < map.stems.size(); ++s) {
    const bool keep = map.stems[s].observations >= min_observations;
    number[s] = keep ? static_cast<std::uint32_t>(stems.size()) : UINT32_MAX;
    if (keep) stems.push_back(map.stems[s]);
  }
  map.stems = std::move(stems);
  for (StemObservation& o : map.observations) o.stem = number[o.stem];
  std::erase_if(map.observations, [](const StemObservation& o) { return o.stem == UINT32_MAX; });
}

}  // namespace

void measure_scatter(StemMap3& map, std::span<const SparseFrame> frames,
                     const FramePoses& T_first_frame) {
  std::vector<double> squares_m2(map.stems.size(), 0.0);
  for (const StemObservation& o : map.observations) {
    const Eigen::Vector3d place_m = T_first_frame[o.frame] * frames[o.frame].points_m[o.point];
    squares_m2[o.stem] += (place_m - map.stems[o.stem].position_in_first_m).head<2>().squaredNorm();
  }
  for (std::size_t s = 0; s < map.stems.size(); ++s) {
    map.stems[s].rmse_m = std::sqrt(squares_m2[s] / std::max(1, map.stems[s].observations));
  }
}

StemMap3 build_stem_map(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
                        const StemMapSettings& settings) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  const LaidPoints laid = lay_into_map(frames, T_first_frame);
  StemMap3 map;
  if (laid.points.empty()) return map;
  Places centres_m = densest_places(laid.places_m, settings);
  for (int round = 0; round < kMeanRounds && !centres_m.empty(); ++round) {
    map.observations = assign(laid, centres_m, settings.gate_m);
    map.stems = average(frames, T_first_frame, map.observations, centres_m.size());
    for (std::size_t s = 0; s < centres_m.size(); ++s) {
      if (map.stems[s].observations > 0) centres_m[s] = map.stems[s].position_in_first_m;
    }
  }
  drop_few(map, settings.min_observations);
  measure_scatter(map, frames, T_first_frame);
  return map;
}

}  // namespace honka
