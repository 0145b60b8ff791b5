#include "algo/localize/tracking/drift_filter.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace honka {

DriftFilter::DriftFilter(const Belief& fix, const OdometryNoiseSettings& noise)
    : drift_variance_(noise.drift * noise.drift),
      drift_length_m_(noise.drift_length_m),
      belief_(fix) {
  covariance_.topLeftCorner<3, 3>() = fix.covariance;
  covariance_.diagonal().tail<2>().setConstant(drift_variance_);
}

void DriftFilter::move(const OdometryStep& step) {
  const double way_m = step.T_last_now.translation_m.norm();
  const double kept = std::exp(-way_m / drift_length_m_);
  const Pose2 now = belief_.T_map_lidar * step.T_last_now;
  Matrix5 F = Matrix5::Zero();
  F.topLeftCorner<3, 3>() = motion_jacobian(belief_.T_map_lidar, now);
  F.block<2, 2>(0, 3).diagonal().setConstant(way_m);
  F.diagonal().tail<2>().setConstant(kept);
  Matrix5 after = F * covariance_ * F.transpose();
  after.topLeftCorner<3, 3>() += covariance_in_map(step, now);
  after.diagonal().tail<2>().array() += drift_variance_ * (1.0 - kept * kept);
  belief_.T_map_lidar = now;
  belief_.T_map_lidar.translation_m += way_m * drift_;
  drift_ *= kept;
  keep(after);
}

void DriftFilter::update(const Belief& fix) {
  const Eigen::Matrix3d sum = covariance_.topLeftCorner<3, 3>() + fix.covariance;
  const Eigen::Matrix<double, 5, 3> gain = sum.ldlt().solve(covariance_.topRows<3>()).transpose();
  const Eigen::Matrix<double, 5, 1> correction =
      gain * pose_difference(fix.T_map_lidar, belief_.T_map_lidar);
  belief_.T_map_lidar.translation_m += correction.head<2>();
  belief_.T_map_lidar.yaw_rad = wrap_to_pi(belief_.T_map_lidar.yaw_rad + correction(2));
  drift_ += correction.tail<2>();
  Matrix5 rest = Matrix5::Identity();
  rest.leftCols<3>() -= gain;
  keep(rest * covariance_ * rest.transpose() + gain * fix.covariance * gain.transpose());
}

void DriftFilter::keep(const Matrix5& covariance) {
  covariance_ = 0.5 * (covariance + covariance.transpose());
  belief_.covariance = covariance_.topLeftCorner<3, 3>();
}

}  // namespace honka
