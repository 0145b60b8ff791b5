#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace honka {

/// Thins a stream of points to one a voxel; deterministic in the order of insertion.
///
/// Voxels are [i·side, (i+1)·side) of the absolute lattice, so that thinning a thinned cloud again
/// changes nothing. Memory follows the voxels in use (about 60 bytes each), not the points seen.
class VoxelGrid {
 public:
  enum class Keep : std::uint8_t { kFirst, kMean };

  explicit VoxelGrid(double side_m, Keep keep = Keep::kFirst);

  /// Adds a point (finite, |coordinate| < 2^31 · side); true when its voxel was empty till now.
  bool insert(const Eigen::Vector3d& point_m);
  [[nodiscard]] std::size_t size() const { return points_m_.size(); }
  /// One point a voxel in order of first insertion: the first point, or the mean of all.
  [[nodiscard]] std::vector<Eigen::Vector3d> points_m() const;

 private:
  using Voxel = std::array<std::int32_t, 3>;
  /// The key beside the index: a look-up touches one place in memory, not two.
  struct Slot {
    Voxel voxel;
    std::uint32_t point;
  };
  [[nodiscard]] Voxel voxel_of(const Eigen::Vector3d& point_m) const;
  [[nodiscard]] Slot& slot_of(const Voxel& voxel);
  void grow();

  double side_m_;
  Keep keep_;
  std::vector<Eigen::Vector3d> points_m_;  ///< first points, or sums for means
  std::vector<std::uint32_t> counts_;      ///< points of each voxel; kept for means only
  std::vector<Slot> slots_;                ///< open addressing, at most two thirds full
};

/// The thinned cloud of points held in memory.
[[nodiscard]] std::vector<Eigen::Vector3d> thin(const std::vector<Eigen::Vector3d>& points_m,
                                                double side_m,
                                                VoxelGrid::Keep keep = VoxelGrid::Keep::kFirst);

}  // namespace honka
