#include "algo/geometry/voxel_grid.h"

#include <cmath>
#include <limits>

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka {
namespace {

constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kFirstSlots = 4096;

}  // namespace

VoxelGrid::VoxelGrid(double side_m, Keep keep)
    : side_m_(side_m), keep_(keep), slots_(kFirstSlots, kEmpty) {
  HONKA_CHECK(side_m > 0.0, "a voxel needs a side");
}

bool VoxelGrid::insert(const Eigen::Vector3d& point_m) {
  const Voxel voxel = voxel_of(point_m);
  std::uint32_t& entry = slots_[slot_of(voxel)];
  if (entry != kEmpty) {
    if (keep_ == Keep::kMean) {
      points_m_[entry] += point_m;
      ++counts_[entry];
    }
    return false;
  }
  entry = static_cast<std::uint32_t>(voxels_.size());
  voxels_.push_back(voxel);
  points_m_.push_back(point_m);
  if (keep_ == Keep::kMean) counts_.push_back(1);
  if (2 * voxels_.size() > slots_.size()) grow();
  return true;
}

std::vector<Eigen::Vector3d> VoxelGrid::points_m() const {
  std::vector<Eigen::Vector3d> points = points_m_;
  for (std::size_t i = 0; i < counts_.size(); ++i) points[i] /= counts_[i];
  return points;
}

VoxelGrid::Voxel VoxelGrid::voxel_of(const Eigen::Vector3d& point_m) const {
  Voxel voxel{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::floor(point_m[axis] / side_m_);
    HONKA_CHECK(std::abs(cell) < 2147483647.0, "point outside the voxel lattice, or not finite");
    voxel[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(cell);
  }
  return voxel;
}

std::size_t VoxelGrid::slot_of(const Voxel& voxel) const {
  const std::size_t mask = slots_.size() - 1;
  const std::uint64_t plane =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(voxel[0])) << 32U) |
      static_cast<std::uint32_t>(voxel[1]);
  std::size_t slot = mix64(plane ^ mix64(static_cast<std::uint32_t>(voxel[2]))) & mask;
  while (slots_[slot] != kEmpty && voxels_[slots_[slot]] != voxel) slot = (slot + 1) & mask;
  return slot;
}

void VoxelGrid::grow() {
  slots_.assign(2 * slots_.size(), kEmpty);
  for (std::uint32_t v = 0; v < voxels_.size(); ++v) slots_[slot_of(voxels_[v])] = v;
}

std::vector<Eigen::Vector3d> thin(const std::vector<Eigen::Vector3d>& points_m, double side_m,
                                  VoxelGrid::Keep keep) {
  VoxelGrid grid(side_m, keep);
  for (const Eigen::Vector3d& p : points_m) grid.insert(p);
  return grid.points_m();
}

}  // namespace honka
