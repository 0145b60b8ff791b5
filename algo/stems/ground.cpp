#include "algo/stems/ground.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "algo/types/check.h"

namespace honka {
namespace {

constexpr double kCell_m = 1.0;
constexpr int kReach = 10;        // cells; gaps between rings of a VLP-16 are 8 m wide at 25 m
constexpr double kSlope = 0.2;    // of ground against the plane through the cloud's lowest points
constexpr double kSlack_m = 0.3;  // roughness of forest ground within a cell
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// z = a + b x + c y through `points`, those far above left out step by step.
Eigen::Vector3d lower_plane(std::vector<Eigen::Vector3d> points) {
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  for (int round = 0; round < 6; ++round) {
    Eigen::Matrix3d normal = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d row(1.0, p.x(), p.y());
      normal += row * row.transpose();
      right += row * p.z();
    }
    plane = normal.ldlt().solve(right);
    const auto above = [&](const Eigen::Vector3d& p) {
      return p.z() - plane.dot(Eigen::Vector3d(1.0, p.x(), p.y())) > 1.0;
    };
    if (points.size() < 20) break;
    points.erase(std::remove_if(points.begin(), points.end(), above), points.end());
  }
  return plane;
}

}  // namespace

GroundGrid::GroundGrid(std::span<const Eigen::Vector3d> points_m) {
  if (points_m.empty()) return;
  keep_lowest(points_m);
  fill(ground_cells());
  smooth();
}

double GroundGrid::height_m(const Eigen::Vector2d& position_m) const {
  if (heights_m_.empty()) return 0.0;
  const Eigen::Vector2d at_cell = (position_m - origin_m_) / kCell_m;
  const double x = std::clamp(at_cell.x(), 0.0, nx_ - 1.0);
  const double y = std::clamp(at_cell.y(), 0.0, ny_ - 1.0);
  const int ix = std::min(static_cast<int>(x), std::max(nx_ - 2, 0));
  const int iy = std::min(static_cast<int>(y), std::max(ny_ - 2, 0));
  const int jx = std::min(ix + 1, nx_ - 1), jy = std::min(iy + 1, ny_ - 1);
  const double fx = x - ix, fy = y - iy;
  const double low = (1.0 - fx) * heights_m_[at(ix, iy)] + fx * heights_m_[at(jx, iy)];
  const double high = (1.0 - fx) * heights_m_[at(ix, jy)] + fx * heights_m_[at(jx, jy)];
  return (1.0 - fy) * low + fy * high;
}

std::size_t GroundGrid::at(int ix, int iy) const {
  return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) +
         static_cast<std::size_t>(ix);
}

void GroundGrid::keep_lowest(std::span<const Eigen::Vector3d> points_m) {
  Eigen::Vector2d low = points_m.front().head<2>(), high = low;
  for (const Eigen::Vector3d& p : points_m) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  HONKA_CHECK((high - low).prod() < 1e8, "a ground grid of more than 100 km²");
  origin_m_ = low.array() + 0.5 * kCell_m;
  nx_ = static_cast<int>((high.x() - low.x()) / kCell_m) + 1;
  ny_ = static_cast<int>((high.y() - low.y()) / kCell_m) + 1;
  heights_m_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), kUnknown);
  for (const Eigen::Vector3d& p : points_m) {
    double& height = heights_m_[at(static_cast<int>((p.x() - low.x()) / kCell_m),
                                   static_cast<int>((p.y() - low.y()) / kCell_m))];
    height = std::min(height, p.z());
  }
}

std::vector<bool> GroundGrid::ground_cells() const {
  std::vector<Eigen::Vector3d> lowest;
  for (int iy = 0; iy < ny_; ++iy) {
    for (int ix = 0; ix < nx_; ++ix) {
      if (heights_m_[at(ix, iy)] < kUnknown) lowest.emplace_back(ix, iy, heights_m_[at(ix, iy)]);
    }
  }
  const Eigen::Vector3d plane = lower_plane(lowest);
  std::vector<double> over(heights_m_);  // height over that plane
  for (const Eigen::Vector3d& p : lowest) {
    over[at(static_cast<int>(p.x()), static_cast<int>(p.y()))] =
        p.z() - plane.dot(Eigen::Vector3d(1.0, p.x(), p.y()));
  }
  std::vector<bool> ground(heights_m_.size(), false);
  for (const Eigen::Vector3d& p : lowest) {
    const int ix = static_cast<int>(p.x()), iy = static_cast<int>(p.y());
    double envelope = kUnknown;
    for (int jy = std::max(iy - kReach, 0); jy <= std::min(iy + kReach, ny_ - 1); ++jy) {
      for (int jx = std::max(ix - kReach, 0); jx <= std::min(ix + kReach, nx_ - 1); ++jx) {
        const double way_m = kCell_m * std::hypot(jx - ix, jy - iy);
        envelope = std::min(envelope, over[at(jx, jy)] + kSlope * way_m);
      }
    }
    ground[at(ix, iy)] = over[at(ix, iy)] <= envelope + kSlack_m;
  }
  return ground;
}

void GroundGrid::fill(const std::vector<bool>& known) {
  // A start from the nearest known cells, ring by ring, then Laplace's equation by relaxation.
  std::vector<double> next(heights_m_.size(), kUnknown);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (!known[i]) heights_m_[i] = kUnknown;
  }
  const int rounds = std::max(2 * kReach, 40);
  bool empty = true;
  for (int round = 0; round < rounds || (empty && round < nx_ + ny_ + rounds); ++round) {
    next = heights_m_;
    empty = false;
    for (int iy = 0; iy < ny_; ++iy) {
      for (int ix = 0; ix < nx_; ++ix) {
        if (known[at(ix, iy)]) continue;
        double sum = 0.0;
        int count = 0;
        const auto take = [&](int jx, int jy) {
          if (jx < 0 || jy < 0 || jx >= nx_ || jy >= ny_) return;
          if (heights_m_[at(jx, jy)] == kUnknown) return;
          sum += heights_m_[at(jx, jy)];
          ++count;
        };
        take(ix - 1, iy), take(ix + 1, iy), take(ix, iy - 1), take(ix, iy + 1);
        if (count > 0) next[at(ix, iy)] = sum / count;
        empty = empty || count == 0;
      }
    }
    heights_m_.swap(next);
  }
}

void GroundGrid::smooth() {
  const std::vector<double> rough = heights_m_;
  for (int iy = 0; iy < ny_; ++iy) {
    for (int ix = 0; ix < nx_; ++ix) {
      double sum = 0.0;
      int count = 0;
      for (int jy = std::max(iy - 1, 0); jy <= std::min(iy + 1, ny_ - 1); ++jy) {
        for (int jx = std::max(ix - 1, 0); jx <= std::min(ix + 1, nx_ - 1); ++jx) {
          sum += rough[at(jx, jy)];
          ++count;
        }
      }
      heights_m_[at(ix, iy)] = sum / count;
    }
  }
}

}  // namespace honka
