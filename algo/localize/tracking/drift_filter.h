#pragma once

#include <Eigen/Core>

#include "algo/localize/tracking/belief.h"

namespace honka {

/// A pose filtered from odometry and fixes. Its error state is (x, y, yaw) and the drift d of the
/// odometry, metres a metre of way along the map's axes: a Gauss–Markov process over the way, whose
/// share in the pose grows with the way and not with its root. An error that lasts is a state
/// (Bryson & Johansen: Linear filtering for time-varying systems using measurements containing
/// colored noise, IEEE Trans. Autom. Control 10(1), 1965).
class DriftFilter {
 public:
  /// Begins at a fix, with the drift of the settings unknown.
  DriftFilter(const Belief& fix, const OdometryNoiseSettings& noise);

  void move(const OdometryStep& step);

  /// The Kalman update by a fix of this pose with an independent error; Joseph's form.
  void update(const Belief& fix);

  [[nodiscard]] const Belief& belief() const { return belief_; }

 private:
  using Matrix5 = Eigen::Matrix<double, 5, 5>;

  void keep(const Matrix5& covariance);

  double drift_variance_ = 0.0;
  double drift_length_m_ = 0.0;
  Belief belief_;  ///< its covariance is that of the first three
  Eigen::Vector2d drift_ = Eigen::Vector2d::Zero();
  Matrix5 covariance_ = Matrix5::Zero();  ///< of (x, y, yaw, d)
};

}  // namespace honka
