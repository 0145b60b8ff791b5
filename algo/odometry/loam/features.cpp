#include "algo/odometry/loam/features.h"

#include <algorithm>
#include <cmath>

#include "algo/odometry/loam/rings.h"

namespace honka {
namespace {

/// The axis of a stem from its free-standing arc: azimuth from its two edges, radius from its
/// width, distance from its mean range. The mean of a half circle seen from afar lies π/4 radii
/// before the centre.
LoamFeature axis_of_arc(const Ring& ring, const Run& run, double step_rad) {
  constexpr double kMeanDepth = 0.785;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double planar_m = 0.0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    mean += ring[i].point_m;
    planar_m += ring[i].point_m.head<2>().norm();
  }
  const auto count = static_cast<double>(run.size());
  mean /= count;
  planar_m /= count;
  const RingPoint& first = ring[run.begin];
  const RingPoint& last = ring[run.end - 1];
  const double width_m = planar_m * step_rad * (last.firing - first.firing + 1);
  const Eigen::Vector2d middle =
      first.point_m.head<2>().normalized() + last.point_m.head<2>().normalized();
  LoamFeature axis;
  axis.point_m.head<2>() = (planar_m + kMeanDepth * 0.5 * width_m) * middle.normalized();
  axis.point_m.z() = mean.z();
  axis.share = 0.5 * (first.share + last.share);
  axis.range_m = axis.point_m.norm();
  axis.curvature = std::max(curvature_at(ring, run.begin), curvature_at(ring, run.end - 1));
  return axis;
}

/// Whether the run is the arc of a stem.
bool add_edge(const Ring& ring, const Run& run, double step_rad, const LoamFeatureSettings& s,
              std::vector<LoamFeature>& edges) {
  if (run.size() < 2 || !run.free_begin || !run.free_end) return false;
  const double width_m = ring[run.begin].range_m * step_rad * static_cast<double>(run.size());
  if (width_m > s.most_edge_width_m) return false;
  const LoamFeature axis = axis_of_arc(ring, run, step_rad);
  if (axis.range_m < s.min_range_m || axis.range_m > s.max_range_m) return false;
  // With nothing behind, there is no point that could curve the ring.
  if (!run.alone && axis.curvature < s.edge_curvature) return false;
  edges.push_back(axis);
  return true;
}

struct PlaneCandidate {
  std::size_t index;
  double curvature;
};

/// Points whose ten neighbours lie on the same run and curve little.
void add_plane_candidates(const Ring& ring, const Run& run, const LoamFeatureSettings& s,
                          std::vector<PlaneCandidate>& candidates) {
  constexpr std::size_t kSide = 5;
  for (std::size_t i = run.begin + kSide; i + kSide < run.end; ++i) {
    if (ring[i].range_m < s.min_range_m || ring[i].range_m > s.max_range_m) continue;
    const double curvature = curvature_at(ring, i);
    if (curvature <= s.plane_curvature) candidates.push_back({i, curvature});
  }
}

/// The smoothest of each sector, none within five points of one taken before.
void pick_planes(const Ring& ring, std::vector<PlaneCandidate>& candidates,
                 const LoamFeatureSettings& s, std::vector<LoamFeature>& planes) {
  constexpr std::int32_t kApart = 5;
  std::sort(candidates.begin(), candidates.end(),
            [](const PlaneCandidate& a, const PlaneCandidate& b) {
              return a.curvature != b.curvature ? a.curvature < b.curvature : a.index < b.index;
            });
  std::vector<std::int64_t> taken(static_cast<std::size_t>(s.sectors), 0);
  std::vector<std::int32_t> firings;
  for (const PlaneCandidate& candidate : candidates) {
    const RingPoint& p = ring[candidate.index];
    const auto sector = static_cast<std::size_t>(
        std::clamp(static_cast<std::int64_t>(p.share * static_cast<double>(s.sectors)),
                   std::int64_t{0}, s.sectors - 1));
    if (taken[sector] >= s.planes_per_sector) continue;
    const bool close = std::any_of(firings.begin(), firings.end(), [&](std::int32_t f) {
      return std::abs(f - p.firing) <= kApart;
    });
    if (close) continue;
    ++taken[sector];
    firings.push_back(p.firing);
    planes.push_back({p.point_m, p.share, p.range_m, candidate.curvature});
  }
}

}  // namespace

std::vector<LoamFeature> thinned(const std::vector<LoamFeature>& features, std::size_t most) {
  if (features.size() <= most) return features;
  std::vector<LoamFeature> kept;
  kept.reserve(most);
  for (std::size_t i = 0; i < most; ++i) kept.push_back(features[i * features.size() / most]);
  return kept;
}

LoamFeatures extract_loam_features(const Sweep& sweep, const LidarModel& model,
                                   const LoamFeatureSettings& settings) {
  const double step_rad = azimuth_step_rad(model);
  LoamFeatures features;
  std::vector<PlaneCandidate> candidates;
  const Rings rings = rings_of(sweep, model);
  for (const Ring& ring : rings.of_laser) {
    candidates.clear();
    for (const Run& run :
         runs_of(ring, settings.depth_step_m, rings.first_firing, rings.last_firing)) {
      if (add_edge(ring, run, step_rad, settings, features.edges)) continue;
      add_plane_candidates(ring, run, settings, candidates);
    }
    pick_planes(ring, candidates, settings, features.planes);
  }
  return features;
}

}  // namespace honka
