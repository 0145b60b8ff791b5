#include "algo/odometry/loam/feature_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka {
namespace {

constexpr int kKeyBits = 21;
constexpr std::int64_t kKeyHalf = std::int64_t{1} << (kKeyBits - 1);

/// Of the key, for a step of (dx, dy, dz) voxels: keys add up.
constexpr std::uint64_t key_step(std::int64_t dx, std::int64_t dy, std::int64_t dz) {
  return static_cast<std::uint64_t>((dx << (2 * kKeyBits)) + (dy << kKeyBits) + dz);
}

}  // namespace

FeatureMap::FeatureMap(double side_m, double height_m, std::int64_t most_points,
                       std::int64_t most_voxels)
    : voxels_per_m_(1.0 / side_m, 1.0 / side_m, 1.0 / height_m),
      most_points_(most_points),
      most_voxels_(most_voxels) {
  HONKA_CHECK(side_m > 0.0 && height_m > 0.0 && most_points > 0 && most_voxels > 0,
              "a map of features needs room");
  clear();
}

void FeatureMap::clear() {
  voxels_.clear();
  slots_.assign(1024, Slot{});
}

std::optional<std::uint64_t> FeatureMap::key_of(const Eigen::Vector3d& point_m) const {
  const Eigen::Vector3d cell = point_m.cwiseProduct(voxels_per_m_).array().floor();
  // One voxel of margin for the neighbours; false for what is no number.
  if (!(cell.cwiseAbs().maxCoeff() < static_cast<double>(kKeyHalf - 2))) return std::nullopt;
  return key_step(static_cast<std::int64_t>(cell.x()) + kKeyHalf,
                  static_cast<std::int64_t>(cell.y()) + kKeyHalf,
                  static_cast<std::int64_t>(cell.z()) + kKeyHalf);
}

std::size_t FeatureMap::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = mix64(key) & mask;
  while (slots_[slot].voxel != kNoVoxel && slots_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

void FeatureMap::rebuild_slots(std::size_t count) {
  slots_.assign(count, Slot{});
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    slots_[slot_of(voxels_[i].key)] = {voxels_[i].key, static_cast<std::uint32_t>(i)};
  }
}

void FeatureMap::insert(const Eigen::Vector3d& point_m, double weight) {
  const auto key = key_of(point_m);
  if (!key || !(weight > 0.0)) return;
  std::size_t slot = slot_of(*key);
  if (slots_[slot].voxel == kNoVoxel) {
    if (2 * (voxels_.size() + 1) > slots_.size()) {
      rebuild_slots(2 * slots_.size());
      slot = slot_of(*key);
    }
    slots_[slot] = {*key, static_cast<std::uint32_t>(voxels_.size())};
    voxels_.push_back({*key, point_m, {}, 0.0, 0});
  }
  Voxel& v = voxels_[slots_[slot].voxel];
  if (v.points >= most_points_) return;
  // Weighted mean and scatter, updated in one pass (West 1979).
  const double total = v.weight + weight;
  const Eigen::Vector3d d = point_m - v.mean_m;
  const double gain = weight * v.weight / total;
  v.scatter[0] += gain * d.x() * d.x();
  v.scatter[1] += gain * d.x() * d.y();
  v.scatter[2] += gain * d.x() * d.z();
  v.scatter[3] += gain * d.y() * d.y();
  v.scatter[4] += gain * d.y() * d.z();
  v.scatter[5] += gain * d.z() * d.z();
  v.mean_m += (weight / total) * d;
  v.weight = total;
  ++v.points;
}

void FeatureMap::keep_near(const Eigen::Vector3d& place_m) {
  const auto most = static_cast<std::size_t>(most_voxels_);
  if (voxels_.size() <= most) return;
  const std::size_t keep = most - most / 10;
  std::vector<std::pair<double, std::uint32_t>> by_distance(voxels_.size());
  for (std::uint32_t i = 0; i < voxels_.size(); ++i) {
    by_distance[i] = {(voxels_[i].mean_m - place_m).squaredNorm(), i};
  }
  std::nth_element(by_distance.begin(), by_distance.begin() + static_cast<std::ptrdiff_t>(keep),
                   by_distance.end());
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < keep; ++i) kept.push_back(by_distance[i].second);
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i < keep; ++i) voxels_[i] = voxels_[kept[i]];
  voxels_.resize(keep);
  rebuild_slots(slots_.size());
}

FeatureMap::Cluster FeatureMap::cluster_at(const Eigen::Vector3d& place_m) const {
  Cluster cluster;
  const auto key = key_of(place_m);
  if (!key) return cluster;
  double weight = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dz = -1; dz <= 1; ++dz) {
        const Slot& slot = slots_[slot_of(*key + key_step(dx, dy, dz))];
        if (slot.voxel == kNoVoxel) continue;
        const Voxel& v = voxels_[slot.voxel];
        const Eigen::Vector3d d = v.mean_m - place_m;
        const Eigen::Vector3d wd = v.weight * d;
        weight += v.weight;
        cluster.points += v.points;
        first += wd;
        second(0, 0) += v.scatter[0] + wd.x() * d.x();
        second(0, 1) += v.scatter[1] + wd.x() * d.y();
        second(0, 2) += v.scatter[2] + wd.x() * d.z();
        second(1, 1) += v.scatter[3] + wd.y() * d.y();
        second(1, 2) += v.scatter[4] + wd.y() * d.z();
        second(2, 2) += v.scatter[5] + wd.z() * d.z();
      }
    }
  }
  if (cluster.points == 0) return cluster;
  const Eigen::Vector3d offset = first / weight;
  cluster.mean_m = place_m + offset;
  cluster.covariance_m2 = Eigen::Matrix3d((second / weight).selfadjointView<Eigen::Upper>()) -
                          offset * offset.transpose();
  return cluster;
}

bool FeatureMap::holds(const Eigen::Vector3d& place_m) const {
  const auto key = key_of(place_m);
  if (!key) return false;
  const Slot& slot = slots_[slot_of(*key)];
  return slot.voxel != kNoVoxel && voxels_[slot.voxel].points >= 3;
}

std::optional<LocalSurface> FeatureMap::line_at(const Eigen::Vector3d& place_m) const {
  constexpr double kLeastVariance_m2 = 0.15 * 0.15;  // along it: three rings of a stem at 10 m
  constexpr double kSlender = 25.0;                  // of variances: five of lengths
  const Cluster cluster = cluster_at(place_m);
  if (cluster.points < 3) return std::nullopt;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(cluster.covariance_m2);
  const Eigen::Vector3d& values = eigen.eigenvalues();
  if (values[2] < kLeastVariance_m2 || values[2] < kSlender * values[1]) return std::nullopt;
  return LocalSurface{cluster.mean_m, eigen.eigenvectors().col(2),
                      std::max(0.0, 0.5 * (values[0] + values[1]))};
}

std::optional<LocalSurface> FeatureMap::plane_at(const Eigen::Vector3d& place_m) const {
  constexpr double kLeastVariance_m2 = 0.2 * 0.2;  // along its shorter axis
  constexpr double kFlat = 9.0;                    // of variances: three of lengths
  const Cluster cluster = cluster_at(place_m);
  if (cluster.points < 5) return std::nullopt;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(cluster.covariance_m2);
  const Eigen::Vector3d& values = eigen.eigenvalues();
  if (values[1] < kLeastVariance_m2 || values[1] < kFlat * values[0]) return std::nullopt;
  return LocalSurface{cluster.mean_m, eigen.eigenvectors().col(0), std::max(0.0, values[0])};
}

std::size_t FeatureMap::bytes() const {
  return voxels_.capacity() * sizeof(Voxel) + slots_.capacity() * sizeof(Slot);
}

}  // namespace honka
