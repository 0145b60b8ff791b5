#pragma once

#include <Eigen/Core>

#include "algo/geometry/se3.h"
#include "algo/odometry/odometry.h"
#include "algo/types/pose.h"

namespace honka {

/// A machine that moves on at its velocity, as a Kalman filter: the pose of the lidar and its
/// velocity in the odom frame, and white acceleration of given s.d. between.
///
/// Small motions are twists (v, ω) in the axes of odom about the lidar: t + v, exp(ω) R.
class MotionFilter {
 public:
  MotionFilter(double acceleration_m_s2, double turn_acceleration_rad_s2);

  /// In a known pose at about a velocity, in the lidar's own axes.
  void start(const Pose3& T_odom_lidar, const Twist& body_velocity = Twist::Zero());
  void predict(double elapsed_s);
  /// The pose moves by `delta`, its covariance becomes `covariance`; the velocity follows as far as
  /// it is correlated with the pose.
  void correct(const Twist& delta, const Covariance6& covariance);
  /// About a pose somewhere else; forgets the velocity.
  void jump_to(const Pose3& T_odom_lidar);
  /// Stands still from now on, as far as is known.
  void halt();

  [[nodiscard]] const Pose3& T_odom_lidar() const { return T_odom_lidar_; }
  [[nodiscard]] Covariance6 pose_covariance() const { return covariance_.topLeftCorner<6, 6>(); }
  /// Velocity as it would be after a correction of the pose by `delta`, in the lidar's own axes.
  [[nodiscard]] Twist body_velocity(const Twist& delta = Twist::Zero()) const;

 private:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  void forget_velocity();
  [[nodiscard]] Covariance6 gain() const;

  double acceleration_, turn_acceleration_;
  Pose3 T_odom_lidar_ = Pose3::Identity();
  Twist velocity_ = Twist::Zero();
  Matrix12 covariance_ = Matrix12::Zero();
};

/// A pose moved by a twist in the axes of odom about the lidar.
[[nodiscard]] Pose3 moved(const Pose3& T_odom_lidar, const Twist& delta);

}  // namespace honka
