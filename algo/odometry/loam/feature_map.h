#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace honka {

/// A straight line or a plane that the points near a place lie on.
struct LocalSurface {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();   ///< mean of the points
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< along the line, or the plane's normal
  double variance_m2 = 0.0;  ///< of the points across the line (one axis) or off the plane
};

/// Bounded map of feature points: of each voxel their number, mean and scatter (weighted), which is
/// all that a line or a plane through them needs. Deterministic in the order of insertion.
class FeatureMap {
 public:
  /// Voxels of `side_m` by `side_m` and `height_m`. A voxel that holds `most_points` takes no
  /// more: what is known well stays where it is. At most `most_voxels`; those farthest from the
  /// last place go first.
  FeatureMap(double side_m, double height_m, std::int64_t most_points, std::int64_t most_voxels);

  /// Adds a point in the map's frame, |coordinate| < 2^20 voxels (others are ignored).
  void insert(const Eigen::Vector3d& point_m, double weight);
  /// Drops the farthest tenth of the voxels when there are more than allowed.
  void keep_near(const Eigen::Vector3d& place_m);
  void clear();

  /// The line through the points of the voxel at `place_m` and the 26 around it: at least three
  /// points, spread along it five times as far as across. Nothing where there is none.
  [[nodiscard]] std::optional<LocalSurface> line_at(const Eigen::Vector3d& place_m) const;
  /// The plane likewise: at least five points, spread along both axes, flat.
  [[nodiscard]] std::optional<LocalSurface> plane_at(const Eigen::Vector3d& place_m) const;

  /// Whether the voxel at the place holds three points or more.
  [[nodiscard]] bool holds(const Eigen::Vector3d& place_m) const;

  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  /// Bytes held, at most 2 × 16 + 96 a voxel and what vectors keep in reserve.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Voxel {
    std::uint64_t key = 0;
    Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
    std::array<double, 6> scatter = {};  ///< xx, xy, xz, yy, yz, zz; times weight
    double weight = 0.0;
    std::int64_t points = 0;
  };
  /// Points around a place as one: their number, mean and covariance.
  struct Cluster {
    std::int64_t points = 0;
    Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  };
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t voxel = kNoVoxel;
  };
  static constexpr std::uint32_t kNoVoxel = 0xffffffffU;

  [[nodiscard]] std::optional<std::uint64_t> key_of(const Eigen::Vector3d& point_m) const;
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  [[nodiscard]] Cluster cluster_at(const Eigen::Vector3d& place_m) const;
  void rebuild_slots(std::size_t count);

  Eigen::Vector3d voxels_per_m_;
  std::int64_t most_points_, most_voxels_;
  std::vector<Voxel> voxels_;
  std::vector<Slot> slots_;  ///< open addressing, a power of two, at most half full
};

}  // namespace honka
