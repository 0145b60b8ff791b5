#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/odometry/stems/settings.h"
#include "algo/odometry/stems/stem_points.h"
#include "algo/types/pose.h"

namespace honka {

/// A sighting with the motion within the sweep taken out: in the lidar frame at mid-sweep.
struct PlacedSighting {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< not of unit length
  double sigma_m = 0.0, slope_sigma = 0.0;
};

/// The axis of a stem in the odom frame: x and y as a line over z. What is known of it adds up in
/// information form, A [place; slope] = b, both columns (x, y) with the same A.
struct StemLandmark {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< at z_m
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double z_m = 0.0;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
  std::int64_t last_key_frame = 0;
  std::int32_t seen = 0;

  [[nodiscard]] Eigen::Vector2d at(double z) const { return place_m + (z - z_m) * slope; }
  /// Variance of either coordinate of the axis at a height.
  [[nodiscard]] double variance_at(double z) const {
    const double h = z - z_m;
    return covariance(0, 0) + 2.0 * h * covariance(0, 1) + h * h * covariance(1, 1);
  }
};

/// Pairs a sighting with a landmark.
struct StemPair {
  std::uint32_t sighting = 0, landmark = 0;
};

/// All stems that the odometry remembers.
class StemLandmarkMap {
 public:
  explicit StemLandmarkMap(const StemLandmarkSettings& settings) : settings_(settings) {}

  [[nodiscard]] std::size_t size() const { return landmarks_.size(); }
  [[nodiscard]] const StemLandmark& operator[](std::uint32_t i) const { return landmarks_[i]; }
  /// Landmarks near the place of the last `look_around`.
  [[nodiscard]] std::span<const std::uint32_t> near() const { return near_; }

  /// Chooses the landmarks that later calls compare with: those around `place_m`.
  void look_around(const Eigen::Vector2d& place_m);

  /// Nearest landmark of each sighting below `gate_m`, each landmark once: the nearer one has it.
  void associate(std::span<const PlacedSighting> sightings, const Pose3& T_odom_mid, double gate_m,
                 std::vector<StemPair>& pairs);

  /// Learns from a key frame: pairs refine their landmarks, lone sightings become new ones.
  void learn(std::span<const PlacedSighting> sightings, const Pose3& T_odom_mid,
             std::span<const StemPair> pairs);

  void clear();

 private:
  void refine(StemLandmark& landmark, const PlacedSighting& sighting, const Pose3& T_odom_mid);
  void forget();

  StemLandmarkSettings settings_;
  std::vector<StemLandmark> landmarks_;
  std::vector<std::uint32_t> near_;
  Eigen::Vector2d looked_from_m_ = Eigen::Vector2d::Constant(1e9);
  std::int64_t key_frame_ = 0;
  std::vector<double> taken_;       ///< by landmark near: squared distance of its sighting
  std::vector<std::int32_t> pair_;  ///< and the place of its pair
};

}  // namespace honka
