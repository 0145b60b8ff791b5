#include "sim/harvester/smooth_path.h"

#include <cmath>

#include "algo/types/check.h"

namespace honka::sim {

SmoothPath::SmoothPath(const Polyline& line) {
  HONKA_CHECK(line.size() >= 2, "a path needs two points");
  length_m_ = sim::length_m(line);
  HONKA_CHECK(length_m_ > 0.0, "a path without length");
  constexpr double kStep_m = 0.5;
  points_ = resampled(line, kStep_m);
  if (points_.size() < 3) points_ = resampled(line, 0.5 * length_m_);
  step_m_ = length_m_ / static_cast<double>(points_.size() - 1);
}

Eigen::Vector2d SmoothPath::control(std::ptrdiff_t i) const {
  const auto last = static_cast<std::ptrdiff_t>(points_.size()) - 1;
  const auto at = [&](std::ptrdiff_t k) { return points_[static_cast<std::size_t>(k)]; };
  if (i < 0) return at(0) + static_cast<double>(i) * (at(1) - at(0));
  if (i > last) return at(last) + static_cast<double>(i - last) * (at(last) - at(last - 1));
  return at(i);
}

Eigen::Vector2d SmoothPath::at(double along_m) const {
  const double place = along_m / step_m_;
  const double cell = std::floor(place);
  const auto i = static_cast<std::ptrdiff_t>(cell);
  const double u = place - cell, v = 1.0 - u;
  return (v * v * v * control(i - 1) + (3 * u * u * u - 6 * u * u + 4) * control(i) +
          (3 * v * v * v - 6 * v * v + 4) * control(i + 1) + u * u * u * control(i + 2)) /
         6.0;
}

}  // namespace honka::sim
