#include "algo/slam/view_cone.h"

#include <cmath>

#include "algo/types/check.h"

namespace honka {

bool ViewCone::holds(const Eigen::Vector2d& point_in_lidar_m) const {
  const Eigen::Vector2d& p = point_in_lidar_m;
  if (!(p.squaredNorm() <= range_m * range_m)) return false;
  return std::abs(std::atan2(p.y(), p.x())) <= deg_to_rad(0.5 * angle_deg);
}

void describe(SettingsVisitor& v, ViewCone& s) {
  v.field({"range_m", "m", "how far a frame sees stems", "Nevalainen2021 §2.3: R = 35"}, s.range_m,
          Range{0.1, 1e3});
  v.field({"angle_deg", "deg", "whole opening of the view, centred on ahead",
           "Li2020 §2.3: 210 degrees in front"},
          s.angle_deg, Range{0.1, 360.0});
}

ViewOverlap::ViewOverlap(const ViewCone& cone, int samples)
    : range_squared_m2_(cone.range_m * cone.range_m),
      cos_half_(std::cos(deg_to_rad(0.5 * cone.angle_deg))),
      sin_half_(std::sin(deg_to_rad(0.5 * cone.angle_deg))),
      all_round_(cone.angle_deg >= 360.0) {
  HONKA_CHECK(samples > 0, "an overlap needs samples");
  const double half_rad = deg_to_rad(0.5 * cone.angle_deg);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int k = 0; k < samples; ++k) {
    const double range_m = cone.range_m * std::sqrt((k + 0.5) / samples);
    const double azimuth_rad = half_rad * (2.0 * std::fmod((k + 0.5) * golden, 1.0) - 1.0);
    x_.push_back(range_m * std::cos(azimuth_rad));
    y_.push_back(range_m * std::sin(azimuth_rad));
  }
}

double ViewOverlap::operator()(const Pose2& T_target_source) const {
  const double c = std::cos(T_target_source.yaw_rad), s = std::sin(T_target_source.yaw_rad);
  const double tx = T_target_source.translation_m.x(), ty = T_target_source.translation_m.y();
  int common = 0;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double x = c * x_[k] - s * y_[k] + tx;
    const double y = s * x_[k] + c * y_[k] + ty;
    const bool near = x * x + y * y <= range_squared_m2_;
    // sin(|azimuth| − half opening) ≤ 0
    const bool open = std::abs(y) * cos_half_ - x * sin_half_ <= 0.0;
    common += static_cast<int>(near & (open | all_round_));
  }
  return static_cast<double>(common) / static_cast<double>(x_.size());
}

double ViewOverlap::operator()(const Pose3& T_target_source) const {
  return (*this)(nearest_planar(T_target_source));
}

std::vector<Eigen::Vector2d> ViewOverlap::samples() const {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t k = 0; k < x_.size(); ++k) points.emplace_back(x_[k], y_[k]);
  return points;
}

double view_overlap(const Pose2& T_target_source, const ViewCone& cone, int samples) {
  return ViewOverlap(cone, samples)(T_target_source);
}

double view_overlap(const Pose3& T_target_source, const ViewCone& cone, int samples) {
  return ViewOverlap(cone, samples)(T_target_source);
}

Pose2 nearest_planar(const Pose3& T_a_b) {
  const auto& R = T_a_b.linear();
  return {T_a_b.translation().head<2>(),
          wrap_to_pi(std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1)))};
}

}  // namespace honka
