#include "algo/odometry/loam/rings.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka {
namespace {

/// Cosines and sines of one laser: of its elevation and of what the sensor turns till it fires.
struct RingBeam {
  double horizontal, vertical, offset_m, cos_lag, sin_lag;
};

std::vector<RingBeam> ring_beams(const LidarModel& model) {
  std::vector<RingBeam> beams;
  for (const Laser& laser : model.lasers) {
    const double lag = 2.0 * kPi * model.rotation_rate_hz * laser.firing_offset_s;
    beams.push_back({std::cos(laser.elevation_rad), std::sin(laser.elevation_rad),
                     laser.vertical_offset_m, std::cos(lag), std::sin(lag)});
  }
  return beams;
}

}  // namespace

double azimuth_step_rad(const LidarModel& model) {
  return 2.0 * kPi * model.rotation_rate_hz * model.firing_period_s;
}

Rings rings_of(const Sweep& sweep, const LidarModel& model) {
  const std::vector<RingBeam> beams = ring_beams(model);
  Rings rings;
  rings.of_laser.resize(beams.size());
  for (Ring& ring : rings.of_laser) ring.reserve(sweep.returns.size() / beams.size() + 64);
  const double longest_s = 1.5 * model.sweep_period_s();
  const double step_rad = azimuth_step_rad(model);
  std::int32_t firing = -1;
  double cosine = 1.0, sine = 0.0;
  for (const Return& r : sweep.returns) {
    const double time_s = 1e-9 * r.time_offset_ns;
    if (r.laser >= beams.size() || r.echo != 0 || time_s > longest_s) continue;
    const auto now = static_cast<std::int32_t>(
        std::floor((time_s - model.lasers[r.laser].firing_offset_s) / model.firing_period_s + 0.5));
    if (rings.last_firing < rings.first_firing) rings.first_firing = rings.last_firing = now;
    rings.first_firing = std::min(rings.first_firing, now);
    rings.last_firing = std::max(rings.last_firing, now);
    if (r.range_ticks == 0) continue;
    if (now != firing) {  // one sine for the 16 lasers of a firing
      firing = now;
      cosine = std::cos(sweep.start_azimuth_rad + step_rad * firing);
      sine = std::sin(sweep.start_azimuth_rad + step_rad * firing);
    }
    Ring& ring = rings.of_laser[r.laser];
    if (!ring.empty() && ring.back().firing >= firing) continue;
    const RingBeam& beam = beams[r.laser];
    const double range_m = model.range_resolution_m * r.range_ticks;
    const double planar_m = range_m * beam.horizontal;
    ring.push_back({{planar_m * (cosine * beam.cos_lag - sine * beam.sin_lag),
                     -planar_m * (sine * beam.cos_lag + cosine * beam.sin_lag),
                     range_m * beam.vertical + beam.offset_m},
                    range_m,
                    time_s * model.rotation_rate_hz,
                    firing});
  }
  return rings;
}

std::vector<Run> runs_of(const Ring& ring, double depth_step_m, std::int32_t first_firing,
                         std::int32_t last_firing) {
  constexpr std::int32_t kMostFirings = 2;  // one lost shot does not end a surface
  std::vector<Run> runs;
  if (ring.empty()) return runs;
  const bool free_first = ring.front().firing - first_firing >= kMostFirings;
  const bool free_last = last_firing - ring.back().firing >= kMostFirings;
  runs.push_back({0, ring.size(), free_first, free_last, free_first});
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const bool gap = ring[i].firing - ring[i - 1].firing > kMostFirings;
    const double step_m = ring[i].range_m - ring[i - 1].range_m;
    if (!gap && std::abs(step_m) <= depth_step_m) continue;
    Run& before = runs.back();
    before.end = i;
    before.free_end = gap || step_m > 0.0;
    before.alone = before.alone || gap;
    runs.push_back({i, ring.size(), gap || step_m < 0.0, free_last, gap});
  }
  runs.back().alone = runs.back().alone || free_last;
  return runs;
}

double curvature_at(const Ring& ring, std::size_t i) {
  constexpr std::size_t kSide = 5;  // Zhang & Singh choose ten points, five on each side
  const std::size_t first = i < kSide ? 0 : i - kSide;
  const std::size_t last = std::min(i + kSide, ring.size() - 1);
  if (last == first) return 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t j = first; j <= last; ++j) sum += ring[j].point_m;
  const auto others = static_cast<double>(last - first);
  sum -= (others + 1.0) * ring[i].point_m;
  return sum.norm() / (others * ring[i].range_m);  // Zhang2014 Eq. (1)
}

}  // namespace honka
