#include "sim/harvester/paths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

constexpr double kStep_m = 0.5;

/// Quarter turns from `from` (heading along ±v) into the next road at `to`; u is the way across.
void append_turn(Polyline& path, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                 const Eigen::Vector2d& ahead, double radius_m) {
  const double gap = (to - from).norm();
  if (gap <= 0.0) return;
  const Eigen::Vector2d across = (to - from) / gap;
  const double r = std::min(radius_m, 0.5 * gap);
  const int pieces = std::max(8, static_cast<int>(std::ceil(0.5 * kPi * r / kStep_m)));
  for (int i = 1; i <= pieces; ++i) {
    const double a = 0.5 * kPi * i / pieces;
    path.emplace_back(from + r * (1.0 - std::cos(a)) * across + r * std::sin(a) * ahead);
  }
  for (int i = 0; i < pieces; ++i) {
    const double a = 0.5 * kPi * i / pieces;
    path.emplace_back(to - r * (1.0 - std::sin(a)) * across + r * std::cos(a) * ahead);
  }
}

struct Bends {
  std::array<double, 2> swing_rad, wave_m, phase_rad;
};

Bends draw_bends(RandomStream& stream) {
  Bends bends;
  bends.wave_m = {stream.uniform(60.0, 100.0), stream.uniform(35.0, 55.0)};
  bends.swing_rad = {stream.uniform(0.3, 0.6), stream.uniform(0.1, 0.3)};
  bends.phase_rad = {stream.uniform(0.0, 2.0 * kPi), stream.uniform(0.0, 2.0 * kPi)};
  double sharpest = 0.0;  // largest possible curvature, 1/m
  for (std::size_t j = 0; j < 2; ++j) {
    sharpest += bends.swing_rad[j] * 2.0 * kPi / bends.wave_m[j];
  }
  const double keep = std::min(1.0, 1.0 / (sharpest * kTurningRadius_m));
  for (double& swing : bends.swing_rad) swing *= keep;
  return bends;
}

Polyline draw_path(double length_m, double heading_rad, const Bends& bends) {
  const auto pieces = static_cast<int>(std::max(1.0, std::round(length_m / kStep_m)));
  const double step = length_m / pieces;
  Polyline path = {Eigen::Vector2d::Zero()};
  for (int i = 0; i < pieces; ++i) {
    const double along = (i + 0.5) * step;
    double heading = heading_rad;
    for (std::size_t j = 0; j < 2; ++j) {
      heading +=
          bends.swing_rad[j] * std::sin(2.0 * kPi * along / bends.wave_m[j] + bends.phase_rad[j]);
    }
    path.emplace_back(path.back() + step * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
  }
  return path;
}

}  // namespace

std::vector<Polyline> strip_roads(const Eigen::AlignedBox2d& extent, double spacing_m) {
  HONKA_CHECK(!extent.isEmpty() && spacing_m > 0.0, "strip roads need an extent and a spacing");
  const Eigen::Vector2d size = extent.sizes();
  const int along = size.y() >= size.x() ? 1 : 0;
  const int across = 1 - along;
  const int count = std::max(1, static_cast<int>(std::floor(size[across] / spacing_m + 1e-9)));
  std::vector<Polyline> roads;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector2d from = extent.min(), to = extent.max();
    from[across] = to[across] = extent.center()[across] + (i - 0.5 * (count - 1)) * spacing_m;
    roads.push_back({from, to});
  }
  return roads;
}

Polyline prior_run_path(const Eigen::AlignedBox2d& extent, double spacing_m,
                        double turning_radius_m) {
  Polyline path;
  const std::vector<Polyline> roads = strip_roads(extent, spacing_m);
  for (std::size_t i = 0; i < roads.size(); ++i) {
    Polyline road = roads[i];
    if (i % 2 == 1) std::reverse(road.begin(), road.end());
    if (i > 0) {
      const Eigen::Vector2d ahead = (road.front() - road.back()).normalized();
      append_turn(path, Eigen::Vector2d(path.back()), road.front(), ahead, turning_radius_m);
    }
    path.insert(path.end(), road.begin(), road.end());
  }
  return path;
}

Polyline work_path(const Eigen::AlignedBox2d& extent, double length_m, std::uint64_t seed) {
  HONKA_CHECK(!extent.isEmpty() && length_m > 0.0, "a work path needs an extent and a length");
  constexpr int kTries = 200;
  Polyline path;
  for (const double margin_m : {40.0, 30.0, 20.0, 10.0, 5.0, 0.0}) {
    for (std::uint64_t attempt = 0; attempt < kTries; ++attempt) {
      RandomStream stream(seed, "work_path", {attempt});
      const double heading = stream.uniform(-kPi, kPi);
      path = draw_path(length_m, heading, draw_bends(stream));
      Eigen::AlignedBox2d box;
      for (const Eigen::Vector2d& p : path) box.extend(p);
      const Eigen::Vector2d shift = extent.center() - box.center();
      for (Eigen::Vector2d& p : path) p += shift;
      const Eigen::Vector2d room = 0.5 * (extent.sizes() - box.sizes());
      if (room.minCoeff() >= margin_m) return path;
    }
  }
  return path;
}

}  // namespace honka::sim
