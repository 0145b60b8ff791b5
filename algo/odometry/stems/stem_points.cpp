#include "algo/odometry/stems/stem_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "algo/stems/centre.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr std::int32_t kFarTicks = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kBuckets = 256;  // 1.4° each: two of them hold a stem's sway between rings
constexpr std::int32_t kOpenEnd = -1;
constexpr std::int32_t kMaxRingGap = 3;  // two rings may miss a stem behind a branch
constexpr double kBarkSigma_m = 0.01;    // what a stem's surface departs from a cylinder
constexpr double kLeastRadius_m = 0.02, kMostRadius_m = 0.4;

/// Weighted line x = at(z̄) + slope · (z − z̄) through arcs.
struct AxisLine {
  double z_m = 0.0;
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero(), slope = Eigen::Vector2d::Zero();
  double weight = 0.0;         ///< Σ w
  double height_weight = 0.0;  ///< Σ w (z − z̄)²
  double share = 0.0;          ///< mean over the arcs

  [[nodiscard]] double distance_m(const StemArc& arc) const {
    return (arc.centre_m.head<2>() - at_m - slope * (arc.centre_m.z() - z_m)).norm();
  }
};

AxisLine line_through(std::span<const StemArc> arcs) {
  AxisLine line;
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (const StemArc& arc : arcs) {
    const double w = 1.0 / (arc.sigma_m * arc.sigma_m);
    line.weight += w;
    line.share += w * arc.share;
    mean_m += w * arc.centre_m;
  }
  mean_m /= line.weight;
  line.share /= line.weight;
  line.z_m = mean_m.z();
  line.at_m = mean_m.head<2>();
  for (const StemArc& arc : arcs) {
    const double w = 1.0 / (arc.sigma_m * arc.sigma_m);
    const Eigen::Vector3d off_m = arc.centre_m - mean_m;
    line.slope += w * off_m.z() * off_m.head<2>();
    line.height_weight += w * off_m.z() * off_m.z();
  }
  if (line.height_weight > 0.0) line.slope /= line.height_weight;
  return line;
}

double radius_of(std::span<const StemArc> arcs) {
  std::array<double, 64> widths{};
  const std::size_t n = std::min(arcs.size(), widths.size());
  for (std::size_t i = 0; i < n; ++i) widths[i] = arcs[i].width_m;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(n / 2);
  std::nth_element(widths.begin(), middle, widths.begin() + static_cast<std::ptrdiff_t>(n));
  return std::clamp(0.5 * *middle, kLeastRadius_m, kMostRadius_m);
}

}  // namespace

StemPointFinder::StemPointFinder(const LidarModel& model, const StemPointSettings& settings)
    : model_(model), settings_(settings) {
  azimuth_per_ns_ = 2.0 * kPi * model.rotation_rate_hz * 1e-9;
  step_rad_ = 2.0 * kPi * model.rotation_rate_hz * model.firing_period_s;
  std::vector<std::size_t> by_elevation(model.lasers.size());
  std::iota(by_elevation.begin(), by_elevation.end(), std::size_t{0});
  std::stable_sort(by_elevation.begin(), by_elevation.end(), [&](std::size_t a, std::size_t b) {
    return model.lasers[a].elevation_rad < model.lasers[b].elevation_rad;
  });
  beams_.resize(model.lasers.size());
  for (std::size_t ring = 0; ring < by_elevation.size(); ++ring) {
    const Laser& laser = model.lasers[by_elevation[ring]];
    beams_[by_elevation[ring]] = {std::cos(laser.elevation_rad), std::sin(laser.elevation_rad),
                                  laser.vertical_offset_m, static_cast<std::int32_t>(ring)};
  }
  segments_.resize(beams_.size());
  ring_arcs_.resize(beams_.size());
  bucket_heads_.resize(kBuckets);
}

const StemPoints& StemPointFinder::find(const Sweep& sweep, const Eigen::Vector3d& up) {
  points_.arcs.clear();
  points_.sightings.clear();
  if (!std::isfinite(sweep.start_azimuth_rad)) return points_;
  segment(sweep);
  chain_arcs();
  keep_stems(up);
  return points_;
}

void StemPointFinder::segment(const Sweep& sweep) {
  for (auto& arcs : ring_arcs_) arcs.clear();
  std::fill(segments_.begin(), segments_.end(), Segment{});
  const auto jump = static_cast<std::int32_t>(settings_.range_jump_m / model_.range_resolution_m);
  const auto most_ns = static_cast<std::uint32_t>(1.5e9 * model_.firing_period_s);
  for (const Return& r : sweep.returns) {
    if (r.echo != 0 || r.laser >= beams_.size()) continue;
    Segment& s = segments_[r.laser];
    const std::int32_t ticks = r.range_ticks;
    const bool next = r.time_offset_ns - s.last_ns < most_ns;
    if (s.returns > 0 && next && ticks > 0 && std::abs(ticks - s.last_ticks) <= jump) {
      ++s.returns;
      s.ticks_sum += r.range_ticks;
    } else {
      const bool far = ticks == 0 || !next;
      if (s.returns > 0) {
        close(s, beams_[r.laser], far ? kFarTicks : ticks, sweep.start_azimuth_rad);
        s.before_ticks = next ? s.last_ticks : kFarTicks;
      } else if (s.before_ticks > 0 && !next) {
        s.before_ticks = kFarTicks;
      }
      if (ticks == 0) s.before_ticks = kFarTicks;
      s.returns = ticks > 0 ? 1 : 0;
      s.first_ns = r.time_offset_ns;
      s.first_ticks = ticks;
      s.ticks_sum = r.range_ticks;
    }
    s.last_ns = r.time_offset_ns;
    s.last_ticks = ticks;
  }
}

void StemPointFinder::close(const Segment& s, const Beam& beam, std::int32_t after_ticks,
                            double start_azimuth_rad) {
  const double range_m =
      model_.range_resolution_m * static_cast<double>(s.ticks_sum) / s.returns * beam.horizontal;
  const double step_m = step_rad_ * range_m;
  const double width_m = s.returns * step_m;
  if (range_m < settings_.min_range_m || range_m > settings_.max_range_m ||
      width_m > settings_.max_width_m) {
    return;
  }
  const auto gap = static_cast<std::int32_t>(settings_.background_m / model_.range_resolution_m);
  if (s.before_ticks - gap < s.first_ticks || after_ticks - gap < s.last_ticks) return;
  StemArc arc;
  const double middle_ns = 0.5 * (static_cast<double>(s.first_ns) + s.last_ns);
  const double azimuth = start_azimuth_rad + azimuth_per_ns_ * middle_ns;
  arc.ray = {std::cos(azimuth), -std::sin(azimuth)};
  arc.range_m = range_m;
  arc.centre_m << range_m * arc.ray, range_m * beam.vertical / beam.horizontal + beam.offset_m;
  arc.width_m = width_m;
  // Two edges, each known to a step: step²/24 across; one ray: step²/12.
  const double across = step_m * step_m / (s.returns > 1 ? 24.0 : 12.0);
  const double along = settings_.range_sigma_m * settings_.range_sigma_m / s.returns;
  arc.sigma_m = std::sqrt(0.5 * (across + along) + kBarkSigma_m * kBarkSigma_m);
  arc.share = middle_ns * 1e-9 * model_.rotation_rate_hz;
  arc.ring = beam.ring;
  arc.returns = s.returns;
  ring_arcs_[static_cast<std::size_t>(beam.ring)].push_back(arc);
}

void StemPointFinder::chain_arcs() {
  arcs_.clear();
  links_.clear();
  std::fill(bucket_heads_.begin(), bucket_heads_.end(), kOpenEnd);
  for (const auto& ring : ring_arcs_) {
    const std::size_t first = arcs_.size();
    for (const StemArc& arc : ring) {
      const std::int32_t below = chain_below(arc);
      if (below != kOpenEnd) links_[static_cast<std::size_t>(below)].topped = true;
      arcs_.push_back(arc);
      links_.push_back({below, kOpenEnd, false});
    }
    for (std::size_t i = first; i < arcs_.size(); ++i) {
      std::int32_t& head = bucket_heads_[bucket_of(arcs_[i])];
      links_[i].next_in_bucket = head;
      head = static_cast<std::int32_t>(i);
    }
  }
}

std::size_t StemPointFinder::bucket_of(const StemArc& arc) {
  return static_cast<std::size_t>(std::clamp(arc.share, 0.0, 0.9999) * kBuckets);
}

std::int32_t StemPointFinder::chain_below(const StemArc& arc) const {
  const auto bucket = static_cast<std::ptrdiff_t>(bucket_of(arc));
  std::int32_t best = kOpenEnd;
  double best_m = std::numeric_limits<double>::infinity();
  for (std::ptrdiff_t b = std::max<std::ptrdiff_t>(bucket - 1, 0);
       b <= std::min<std::ptrdiff_t>(bucket + 1, kBuckets - 1); ++b) {
    for (std::int32_t i = bucket_heads_[static_cast<std::size_t>(b)]; i != kOpenEnd;
         i = links_[static_cast<std::size_t>(i)].next_in_bucket) {
      const StemArc& low = arcs_[static_cast<std::size_t>(i)];
      if (arc.ring - low.ring > kMaxRingGap) break;  // lists hold higher rings first
      if (links_[static_cast<std::size_t>(i)].topped) continue;
      const double rise_m = arc.centre_m.z() - low.centre_m.z();
      const double apart_m = (arc.centre_m - low.centre_m).head<2>().norm();
      // Bark and grid, and a lean of up to 20° with the lidar's own tilt.
      if (apart_m > 0.12 + 0.4 * rise_m || apart_m > 0.6 || apart_m >= best_m) continue;
      best = i;
      best_m = apart_m;
    }
  }
  return best;
}

void StemPointFinder::keep_stems(const Eigen::Vector3d& up) {
  const Eigen::Vector2d upright = up.head<2>() / std::max(up.z(), 0.1);
  const double most_slope = std::tan(deg_to_rad(settings_.max_lean_deg));
  for (std::size_t top = 0; top < arcs_.size(); ++top) {
    if (links_[top].topped) continue;
    const std::size_t first = points_.arcs.size();
    for (auto i = static_cast<std::int32_t>(top); i != kOpenEnd;
         i = links_[static_cast<std::size_t>(i)].below) {
      points_.arcs.push_back(arcs_[static_cast<std::size_t>(i)]);
    }
    StemSighting s;
    const std::size_t kept = fit_axis(std::span(points_.arcs).subspan(first), s);
    if (kept == 0 || (s.slope - upright).norm() > most_slope) {
      points_.arcs.resize(first);
      continue;
    }
    points_.arcs.resize(first + kept);
    s.first_arc = static_cast<std::uint32_t>(first);
    points_.sightings.push_back(s);
  }
}

std::size_t StemPointFinder::fit_axis(std::span<StemArc> arcs, StemSighting& s) const {
  const auto least = static_cast<std::size_t>(settings_.min_rings);
  if (arcs.size() < least) return 0;
  // Surface to axis.
  s.radius_m = radius_of(arcs);
  for (StemArc& arc : arcs) arc.centre_m.head<2>() += kMeanDepth * s.radius_m * arc.ray;
  // Twice without what is off the line: branches join a chain as arcs of their own.
  for (int pass = 0; pass < 2; ++pass) {
    const AxisLine line = line_through(arcs);
    const auto off = std::remove_if(arcs.begin(), arcs.end(), [&](const StemArc& arc) {
      return line.distance_m(arc) > settings_.max_bend_m + 2.0 * arc.sigma_m;
    });
    arcs = arcs.first(static_cast<std::size_t>(off - arcs.begin()));
    if (arcs.size() < least) return 0;
  }
  const AxisLine line = line_through(arcs);
  const auto [low, high] = std::minmax_element(
      arcs.begin(), arcs.end(),
      [](const StemArc& a, const StemArc& b) { return a.centre_m.z() < b.centre_m.z(); });
  s.span_m = high->centre_m.z() - low->centre_m.z();
  if (s.span_m < settings_.min_span_m) return 0;
  double chi2 = 0.0;
  for (const StemArc& arc : arcs) chi2 += std::pow(line.distance_m(arc) / arc.sigma_m, 2);
  const double degrees = 2.0 * static_cast<double>(arcs.size()) - 4.0;
  s.centre_m << line.at_m, line.z_m;
  s.slope = line.slope;
  const double excess = std::max(1.0, chi2 / degrees);
  s.centre_sigma_m = std::sqrt(excess / line.weight);
  s.slope_sigma = std::sqrt(excess / line.height_weight);
  s.share = line.share;
  s.arcs = static_cast<std::uint32_t>(arcs.size());
  return arcs.size();
}

}  // namespace honka
