#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/odometry/odometry.h"
#include "algo/odometry/stems/ground_plane.h"
#include "algo/odometry/stems/landmarks.h"
#include "algo/odometry/stems/settings.h"

namespace honka {

/// A sweep with its motion taken out: all in the lidar frame at mid-sweep.
struct PlacedSweep {
  std::vector<PlacedSighting> sightings;
  std::vector<Eigen::Vector3d> ground_m;
};

/// Moves what was seen during a sweep to its middle, at constant body velocity (1/s).
void place(const StemPoints& points, const std::vector<GroundPoint>& ground,
           const Twist& body_velocity, double period_s, PlacedSweep& placed);

struct StemFit {
  Twist delta = Twist::Zero();  ///< from the predicted pose, as in MotionFilter
  Pose3 T_odom_mid = Pose3::Identity();
  Covariance6 information = Covariance6::Zero();  ///< of the sweep alone
  std::size_t stems = 0;                          ///< pairs that fit
  double share = 0.0;                             ///< of the sightings that fit
  bool at_rest = false;                           ///< the last step was small
};

/// Registers sweeps to the maps of stems and ground.
///
/// Least squares over the six of SE(3): stems give x, y and yaw, and their axes with the ground
/// roll and pitch, the ground z. Pairs are chosen anew before every third step; residuals are in
/// units of their s.d. with Tukey weights whose width follows the median residual, which trims what
/// is no stem or moves. What the sweep does not determine stays with the prediction.
class StemRegistration {
 public:
  StemRegistration(const StemRegistrationSettings& settings, const StemLandmarkSettings& landmarks,
                   const StemGroundSettings& ground);

  /// `prior`: information of the predicted pose; `start`: where to begin, as a delta from it.
  [[nodiscard]] StemFit fit(const PlacedSweep& sweep, StemLandmarkMap& stems,
                            const GroundMap& ground, const Pose3& T_odom_predicted,
                            const Covariance6& prior, const Twist& start);
  /// Pairs of the last fit that agree with it.
  [[nodiscard]] const std::vector<StemPair>& pairs() const { return pairs_; }

 private:
  struct Normal {
    Covariance6 H = Covariance6::Zero();
    Twist g = Twist::Zero();
  };
  struct GroundTie {
    std::uint32_t point;
    GroundPlane plane;
  };
  struct PairResidual {
    Eigen::Vector2d place, slope;  ///< over their s.d.
    double place_sigma_m, slope_sigma;
    Eigen::Vector3d lever_m;
  };
  void tie_ground(const PlacedSweep& sweep, const GroundMap& ground, const Pose3& T_odom_mid);
  void residuals(const PlacedSweep& sweep, const StemLandmarkMap& stems, const Pose3& T_odom_mid);
  [[nodiscard]] double median_scale();
  void add_stems(double scale, Normal& normal) const;
  void add_ground(const PlacedSweep& sweep, const Pose3& T_odom_mid, Normal& normal) const;
  void keep_fitting(double scale);

  StemRegistrationSettings settings_;
  StemLandmarkSettings landmarks_;
  StemGroundSettings ground_;
  std::vector<StemPair> pairs_;
  std::vector<GroundTie> ties_;
  std::vector<PairResidual> residuals_;
  std::vector<double> sizes_;
};

}  // namespace honka
