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
    : side_m_(side_m), keep_(keep), slots_(kFirstSlots, {{}, kEmpty}) {
  HONKA_CHECK(side_m > 0.0, "a voxel needs a side");
}

bool VoxelGrid::insert(const Eigen::Vector3d& point_m) {
  const Voxel voxel = voxel_of(point_m);
  Slot& slot = slot_of(voxel);
  if (slot.point != kEmpty) {
    if (keep_ == Keep::kMean) {
      points_m_[slot.point] += point_m;
      ++counts_[slot.point];
    }
    return false;
  }
  slot = {voxel, static_cast<std::uint32_t>(points_m_.size())};
  points_m_.push_back(point_m);
  if (keep_ == Keep::kMean) counts_.push_back(1);
  if (3 * points_m_.size() > 2 * slots_.size()) grow();
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

VoxelGrid::Slot& VoxelGrid::slot_of(const Voxel& voxel) {
  const std::size_t mask = slots_.size() - 1;
  const std::uint64_t plane =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(voxel[0])) << 32U) |
      static_cast<std::uint32_t>(voxel[1]);
  std::size_t slot = mix64(plane ^ mix64(static_cast<std::uint32_t>(voxel[2]))) & mask;
  const auto taken_by_another = [&](const Slot& s) {
    return s.point != kEmpty &&
           (s.voxel[0] != voxel[0] || s.voxel[1] != voxel[1] || s.voxel[2] != voxel[2]);
  };
  while (taken_by_another(slots_[slot])) slot = (slot + 1) & mask;
  return slots_[slot];
}

void VoxelGrid::grow() {
  std::vector<Slot> smaller(2 * slots_.size(), {{}, kEmpty});
  smaller.swap(slots_);
  for (const Slot& slot : smaller) {
    if (slot.point != kEmpty) slot_of(slot.voxel) = slot;
  }
}

std::vector<Eigen::Vector3d> thin(const std::vector<Eigen::Vector3d>& points_m, double side_m,
                                  VoxelGrid::Keep keep) {
  VoxelGrid grid(side_m, keep);
  for (const Eigen::Vector3d& p : points_m) grid.insert(p);
  return grid.points_m();
}

}  // namespace honka
