#include "algo/odometry/stems/ground_plane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr std::int32_t kMostPoints = 100;  // a mean over the last of them: ground that is revisited

}  // namespace

GroundPicker::GroundPicker(const LidarModel& model, const StemGroundSettings& settings,
                           double min_range_m)
    : model_(model), settings_(settings), min_range_m_(min_range_m) {
  std::vector<std::uint8_t> lasers(model.lasers.size());
  std::iota(lasers.begin(), lasers.end(), std::uint8_t{0});
  const auto elevation = [&](std::uint8_t laser) { return model.lasers[laser].elevation_rad; };
  std::stable_sort(lasers.begin(), lasers.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return elevation(a) < elevation(b); });
  for (const std::uint8_t laser : lasers) {
    if (elevation(laser) < 0.0) lasers_down_.push_back(laser);
  }
  column_.resize(model.lasers.size());
}

const std::vector<GroundPoint>& GroundPicker::pick(const Sweep& sweep, const Eigen::Vector3d& up) {
  points_.clear();
  const double most_slope = std::tan(deg_to_rad(settings_.max_slope_deg));
  const double firing_ns = 1e9 * model_.firing_period_s;
  const auto column_ns = static_cast<std::int64_t>(firing_ns);
  const auto stride_ns = static_cast<std::int64_t>(firing_ns * settings_.firing_step);
  std::int64_t begin_ns = -1;
  for (std::size_t i = 0; i < sweep.returns.size();) {
    begin_ns = sweep.returns[i].time_offset_ns;
    std::fill(column_.begin(), column_.end(), Return{});
    for (; i < sweep.returns.size(); ++i) {
      const Return& r = sweep.returns[i];
      if (r.time_offset_ns - begin_ns >= column_ns || r.time_offset_ns < begin_ns) break;
      if (r.echo == 0 && r.laser < column_.size()) column_[r.laser] = r;
    }
    take_column(sweep, up, most_slope);
    // Skip to the next column: the returns come in the order of time.
    const auto next = std::lower_bound(
        sweep.returns.begin() + static_cast<std::ptrdiff_t>(i), sweep.returns.end(),
        begin_ns + stride_ns, [](const Return& r, std::int64_t t) { return r.time_offset_ns < t; });
    i = std::max(i, static_cast<std::size_t>(next - sweep.returns.begin()));
  }
  return points_;
}

void GroundPicker::take_column(const Sweep& sweep, const Eigen::Vector3d& up, double most_slope) {
  bool first = true;
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero();
  double low_share = 0.0;
  for (const std::uint8_t laser : lasers_down_) {
    const Return& r = column_[laser];
    const double range_m = model_.range_resolution_m * r.range_ticks;
    if (range_m < min_range_m_ || range_m > settings_.max_range_m) continue;
    const Eigen::Vector3d point_m = sweep.point_in_lidar(r, model_);
    const double share = 1e-9 * r.time_offset_ns * model_.rotation_rate_hz;
    if (!first) {
      const Eigen::Vector3d way_m = point_m - low_m;
      const double rise_m = way_m.dot(up);
      const double run_m = (way_m - rise_m * up).norm();
      if (std::abs(rise_m) > most_slope * run_m) break;
      points_.push_back({low_m, low_share});
    }
    first = false;
    low_m = point_m;
    low_share = share;
  }
}

GroundMap::GroundMap(const StemGroundSettings& settings) : settings_(settings) { clear(); }

void GroundMap::clear() {
  cells_.assign(static_cast<std::size_t>(settings_.cells * settings_.cells), Cell{});
}

std::size_t GroundMap::at(std::int32_t ix, std::int32_t iy) const {
  const auto n = static_cast<std::int32_t>(settings_.cells);
  const std::int32_t x = ((ix % n) + n) % n, y = ((iy % n) + n) % n;
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x);
}

void GroundMap::add(const Eigen::Vector3d& p) {
  const auto ix = static_cast<std::int32_t>(std::floor(p.x() / settings_.cell_m));
  const auto iy = static_cast<std::int32_t>(std::floor(p.y() / settings_.cell_m));
  Cell& cell = cells_[at(ix, iy)];
  const Eigen::Vector3f local_m(static_cast<float>(p.x() - ix * settings_.cell_m),
                                static_cast<float>(p.y() - iy * settings_.cell_m),
                                static_cast<float>(p.z()));
  const bool foreign = cell.ix != ix || cell.iy != iy;
  const float rise_m = local_m.z() - cell.mean_m.z();
  const auto tolerance_m = static_cast<float>(settings_.tolerance_m);
  // What lies lower is nearer to being ground.
  if (foreign || cell.points == 0 || rise_m < -tolerance_m) {
    cell = {ix, iy, 1, local_m};
    return;
  }
  if (rise_m > tolerance_m) return;
  cell.points = std::min(cell.points + 1, kMostPoints);
  cell.mean_m += (local_m - cell.mean_m) / static_cast<float>(cell.points);
}

std::optional<GroundPlane> GroundMap::plane_at(const Eigen::Vector2d& place_m) const {
  const auto ix = static_cast<std::int32_t>(std::floor(place_m.x() / settings_.cell_m));
  const auto iy = static_cast<std::int32_t>(std::floor(place_m.y() / settings_.cell_m));
  int known = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, 9> means;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const Cell& cell = cells_[at(ix + dx, iy + dy)];
      if (cell.points == 0 || cell.ix != ix + dx || cell.iy != iy + dy) continue;
      Eigen::Vector3d mean = cell.mean_m.cast<double>();
      mean.x() += dx * settings_.cell_m;
      mean.y() += dy * settings_.cell_m;
      means[static_cast<std::size_t>(known++)] = mean;
      sum += mean;
    }
  }
  if (known < 4) return std::nullopt;
  const Eigen::Vector3d centre = sum / known;
  // A hundredth of a cell's square each way: keeps the plane of cells in a row level across it.
  Eigen::Matrix2d square = Eigen::Matrix2d::Identity() * (0.01 * settings_.cell_m);
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (int i = 0; i < known; ++i) {
    const Eigen::Vector3d d = means[static_cast<std::size_t>(i)] - centre;
    square += d.head<2>() * d.head<2>().transpose();
    right += d.z() * d.head<2>();
  }
  GroundPlane plane;
  plane.slope = square.inverse() * right;
  plane.centre_m = centre;
  plane.centre_m.x() += ix * settings_.cell_m;
  plane.centre_m.y() += iy * settings_.cell_m;
  return plane;
}

}  // namespace honka
