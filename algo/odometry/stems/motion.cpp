#include "algo/odometry/stems/motion.h"

#include <Eigen/Cholesky>

namespace honka {
namespace {

// What a forest machine may do when nothing is known of its motion yet.
constexpr double kStartSpeed_m_s = 1.0, kStartTurn_rad_s = 0.3;
constexpr double kStartSigma = 1e-3;                  // m and rad: a pose by definition
constexpr double kFound_m = 0.5, kFound_rad = 0.035;  // a cell and a step of the search

}  // namespace

Pose3 moved(const Pose3& T_odom_lidar, const Twist& delta) {
  Pose3 pose = T_odom_lidar;
  pose.translation() += delta.head<3>();
  // Orthonormal again: products of thousands of sweeps drift off SO(3).
  pose.linear() =
      Eigen::Quaterniond(so3_exp(delta.tail<3>()) * T_odom_lidar.linear()).normalized().matrix();
  return pose;
}

MotionFilter::MotionFilter(double acceleration_m_s2, double turn_acceleration_rad_s2)
    : acceleration_(acceleration_m_s2), turn_acceleration_(turn_acceleration_rad_s2) {
  start(Pose3::Identity());
}

void MotionFilter::forget_velocity() {
  velocity_.setZero();
  covariance_.topRightCorner<6, 6>().setZero();
  covariance_.bottomLeftCorner<6, 6>().setZero();
  covariance_.bottomRightCorner<6, 6>().setZero();
  covariance_.diagonal().segment<3>(6).setConstant(kStartSpeed_m_s * kStartSpeed_m_s);
  covariance_.diagonal().tail<3>().setConstant(kStartTurn_rad_s * kStartTurn_rad_s);
}

void MotionFilter::start(const Pose3& T_odom_lidar, const Twist& body_velocity) {
  T_odom_lidar_ = T_odom_lidar;
  covariance_.setZero();
  covariance_.diagonal().head<6>().setConstant(kStartSigma * kStartSigma);
  forget_velocity();
  velocity_ << T_odom_lidar.linear() * body_velocity.head<3>(),
      T_odom_lidar.linear() * body_velocity.tail<3>();
}

void MotionFilter::jump_to(const Pose3& T_odom_lidar) {
  start(T_odom_lidar);
  covariance_.diagonal().head<3>().setConstant(kFound_m * kFound_m);
  covariance_.diagonal().segment<3>(3).setConstant(kFound_rad * kFound_rad);
}

void MotionFilter::halt() { forget_velocity(); }

void MotionFilter::predict(double elapsed_s) {
  T_odom_lidar_ = moved(T_odom_lidar_, velocity_ * elapsed_s);
  // F = [I, dt I; 0, I]; white acceleration held over the interval.
  auto pp = covariance_.topLeftCorner<6, 6>();
  auto pv = covariance_.topRightCorner<6, 6>();
  auto vv = covariance_.bottomRightCorner<6, 6>();
  pp += elapsed_s * (pv + pv.transpose()).eval() + elapsed_s * elapsed_s * vv;
  pv += elapsed_s * vv;
  const double t2 = elapsed_s * elapsed_s;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double a = i < 3 ? acceleration_ : turn_acceleration_;
    pp(i, i) += 0.25 * a * a * t2 * t2;
    pv(i, i) += 0.5 * a * a * t2 * elapsed_s;
    vv(i, i) += a * a * t2;
  }
  covariance_.bottomLeftCorner<6, 6>() = pv.transpose();
}

Covariance6 MotionFilter::gain() const {
  const Covariance6 pp = covariance_.topLeftCorner<6, 6>();
  const Covariance6 pv = covariance_.topRightCorner<6, 6>();
  return pp.ldlt().solve(pv).transpose();
}

Twist MotionFilter::body_velocity(const Twist& delta) const {
  const Twist velocity = delta.isZero(0.0) ? velocity_ : Twist(velocity_ + gain() * delta);
  const Eigen::Matrix3d R_lidar_odom =
      (so3_exp(delta.tail<3>()) * T_odom_lidar_.linear()).transpose();
  Twist body;
  body << R_lidar_odom * velocity.head<3>(), R_lidar_odom * velocity.tail<3>();
  return body;
}

void MotionFilter::correct(const Twist& delta, const Covariance6& covariance) {
  const Covariance6 k = gain();
  velocity_ += k * delta;
  T_odom_lidar_ = moved(T_odom_lidar_, delta);
  const Covariance6 shrunk = covariance_.topLeftCorner<6, 6>() - covariance;
  covariance_.bottomRightCorner<6, 6>() -= k * shrunk * k.transpose();
  covariance_.bottomLeftCorner<6, 6>() = k * covariance;
  covariance_.topRightCorner<6, 6>() = covariance * k.transpose();
  covariance_.topLeftCorner<6, 6>() = covariance;
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

}  // namespace honka
