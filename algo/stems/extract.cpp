#include "algo/stems/extract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "algo/geometry/cell_index.h"
#include "algo/geometry/neighbours.h"
#include "algo/geometry/voxel_grid.h"
#include "algo/stems/centre.h"
#include "algo/stems/ground.h"
#include "algo/types/check.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using Indices = std::vector<std::uint32_t>;
enum class Centre : std::uint8_t { kMean, kBiasCorrected, kCircleFit };

/// The words of the settings, read once.
struct Choice {
  bool journal;
  NeighbourSearch search;
  Centre centre;
};

std::size_t word(const char* key, const std::string& value, const Choices& choices) {
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  throw UserError(fmt::format("stems.{}: \"{}\" is unknown; use {}", key, value,
                              fmt::format("{}", fmt::join(choices, " | "))));
}

Choice read_choice(const StemSettings& s) {
  return {word("form", s.form, {"journal", "preprint"}) == 0,
          word("search", s.search, {"kd_tree", "voxel_hash"}) == 0 ? NeighbourSearch::kKdTree
                                                                   : NeighbourSearch::kVoxelHash,
          static_cast<Centre>(word("centre", s.centre, {"mean", "bias_corrected", "circle_fit"}))};
}

void check_cloud(const LocalCloud& cloud) {
  HONKA_CHECK(cloud.frames.empty() || cloud.frames.size() == cloud.size(),
              "one frame index a point, or none");
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points_m[i].allFinite()) {
      throw UserError(fmt::format("point cloud: point {} is not finite; remove it", i));
    }
  }
  for (const std::uint32_t frame : cloud.frames) {
    HONKA_CHECK(frame < cloud.origins_m.size(), "a point of a frame without an origin");
  }
}

/// Points near enough to their sensor, one a voxel where asked.
Indices near_and_thin(const LocalCloud& cloud, const StemSettings& settings) {
  const double squared_range = settings.max_range_m * settings.max_range_m;
  VoxelGrid voxels(settings.voxel_m > 0.0 ? settings.voxel_m : 1.0);
  Indices kept;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d& p = cloud.points_m[i];
    if (!cloud.frames.empty() &&
        (p - cloud.origins_m[cloud.frames[i]]).squaredNorm() > squared_range) {
      continue;
    }
    if (settings.voxel_m > 0.0 && !voxels.insert(p)) continue;
    kept.push_back(i);
  }
  return kept;
}

std::vector<Eigen::Vector3d> points_of(const LocalCloud& cloud, const Indices& indices) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(indices.size());
  for (const std::uint32_t i : indices) points.push_back(cloud.points_m[i]);
  return points;
}

std::vector<Eigen::Vector2d> plane_of(const LocalCloud& cloud, const Indices& indices) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(indices.size());
  for (const std::uint32_t i : indices) points.emplace_back(cloud.points_m[i].head<2>());
  return points;
}

Indices chosen(const Indices& indices, const std::vector<std::uint8_t>& keep) {
  Indices kept;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (keep[k] != 0) kept.push_back(indices[k]);
  }
  return kept;
}

Indices in_band(const LocalCloud& cloud, const Indices& indices, const GroundGrid& ground,
                const StemSettings& settings) {
  Indices kept;
  for (const std::uint32_t i : indices) {
    const Eigen::Vector3d& p = cloud.points_m[i];
    const double height_m = p.z() - ground.height_m(p.head<2>());
    if (height_m >= settings.band_low_m && height_m <= settings.band_high_m) kept.push_back(i);
  }
  return kept;
}

/// Li2020 Algorithm 1, lines 1–8, and the journal's projection and planar test.
Indices trunk_points(const LocalCloud& cloud, const Indices& usable, const StemSettings& settings,
                     const Choice& choice) {
  const Indices raised =
      chosen(usable, has_neighbour_above(points_of(cloud, usable), settings.height_offset_m,
                                         settings.d_threshold_m, choice.search));
  if (!choice.journal) return raised;
  return chosen(raised,
                has_other_within(plane_of(cloud, raised), settings.planar_radius_m, choice.search));
}

/// Points that a cluster must have: the threshold, and its share for each sweep of the cloud.
std::size_t least_points(const LocalCloud& cloud, const StemSettings& settings) {
  const double stable = settings.points_per_sweep * static_cast<double>(cloud.origins_m.size());
  return std::max(static_cast<std::size_t>(settings.cluster_threshold),
                  static_cast<std::size_t>(std::ceil(stable)));
}

/// Groups of `trunk`, each by rising index.
std::vector<Indices> clusters_of(const LocalCloud& cloud, const Indices& trunk,
                                 const StemSettings& settings, const Choice& choice) {
  const double link_m = settings.cluster_link_m;
  const std::vector<std::uint32_t> labels =
      choice.journal ? euclidean_clusters<2>(plane_of(cloud, trunk), link_m, choice.search)
                     : euclidean_clusters<3>(points_of(cloud, trunk), link_m, choice.search);
  const std::size_t least = least_points(cloud, settings);
  const CellIndex groups(std::vector<std::uint64_t>(labels.begin(), labels.end()));
  std::vector<Indices> clusters;
  for (std::size_t g = 0; g < groups.cell_count(); ++g) {
    const auto members = groups.members(g);
    if (members.size() < least) continue;
    Indices& cluster = clusters.emplace_back();
    for (const std::uint32_t member : members) cluster.push_back(trunk[member]);
  }
  return clusters;
}

std::vector<SeenPoint> seen_points(const LocalCloud& cloud, const Indices& cluster) {
  std::vector<SeenPoint> points;
  points.reserve(cluster.size());
  for (const std::uint32_t i : cluster) {
    const Eigen::Vector2d position = cloud.points_m[i].head<2>();
    Eigen::Vector2d ray = Eigen::Vector2d::Zero();
    if (!cloud.frames.empty()) {
      ray = (position - cloud.origins_m[cloud.frames[i]].head<2>()).stableNormalized();
    }
    points.push_back({position, ray});
  }
  return points;
}

/// Evenly chosen points, enough for a circle: its error falls no further with thousands of them,
/// as taper and lean are then all that is left.
std::vector<SeenPoint> for_circle(const std::vector<SeenPoint>& points) {
  constexpr std::size_t kEnough = 400;
  const std::size_t step = (points.size() + kEnough - 1) / kEnough;
  if (step <= 1) return points;
  std::vector<SeenPoint> chosen;
  for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back(points[i]);
  return chosen;
}

ObservedStem stem_of(const LocalCloud& cloud, const Indices& cluster, Centre centre) {
  const std::vector<SeenPoint> points = seen_points(cloud, cluster);
  const std::optional<Circle> circle = circle_fit(for_circle(points));
  ObservedStem stem;
  stem.position_m = centre == Centre::kMean                  ? mean_of(points)
                    : centre == Centre::kCircleFit && circle ? circle->centre_m
                                                             : bias_corrected(points).centre_m;
  if (circle) stem.dbh_m = 2.0 * circle->radius_m;
  stem.points = static_cast<std::int32_t>(cluster.size());
  stem.z_m = cloud.points_m[cluster.front()].z();
  for (const std::uint32_t i : cluster) stem.z_m = std::min(stem.z_m, cloud.points_m[i].z());
  return stem;
}

void mark(std::vector<PointStage>& stages, const Indices& indices, PointStage stage) {
  for (const std::uint32_t i : indices) stages[i] = stage;
}

}  // namespace

StemExtraction extract_stems(const LocalCloud& cloud, const StemSettings& settings) {
  const Choice choice = read_choice(settings);
  check_cloud(cloud);
  StemExtraction result;
  result.stages.assign(cloud.size(), PointStage::kDropped);
  Indices usable = near_and_thin(cloud, settings);
  std::optional<GroundGrid> ground;
  if (settings.height_band && !usable.empty()) {
    ground.emplace(points_of(cloud, usable));
    usable = in_band(cloud, usable, *ground, settings);
  }
  const Indices trunk = trunk_points(cloud, usable, settings, choice);
  mark(result.stages, trunk, PointStage::kTrunkCandidate);
  for (const Indices& cluster : clusters_of(cloud, trunk, settings, choice)) {
    mark(result.stages, cluster, PointStage::kClustered);
    ObservedStem stem = stem_of(cloud, cluster, choice.centre);
    if (ground) stem.z_m = ground->height_m(stem.position_m);
    result.stems.push_back(stem);
  }
  std::sort(result.stems.begin(), result.stems.end(),
            [](const ObservedStem& a, const ObservedStem& b) {
              return a.position_m.x() != b.position_m.x() ? a.position_m.x() < b.position_m.x()
                                                          : a.position_m.y() < b.position_m.y();
            });
  return result;
}

StemMap stem_map_of(const std::vector<ObservedStem>& stems) {
  StemMap map;
  map.reserve(stems.size());
  for (const ObservedStem& stem : stems) {
    map.push_back({stem.position_m, stem.z_m, stem.dbh_m, std::nullopt, stem.points});
  }
  return map;
}

}  // namespace honka
