#include "sim/world/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algo/types/check.h"

namespace honka::sim {

double length_m(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

Eigen::Vector2d point_at(const Polyline& line, double along_m) {
  HONKA_CHECK(!line.empty(), "a point on an empty line");
  double left = std::max(0.0, along_m);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = (line[i] - line[i - 1]).norm();
    if (left <= piece && piece > 0.0) return line[i - 1] + (left / piece) * (line[i] - line[i - 1]);
    left -= piece;
  }
  return line.back();
}

double distance_m(const Polyline& line, const Eigen::Vector2d& point_m) {
  if (line.size() == 1) return (point_m - line[0]).norm();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d piece = line[i] - line[i - 1];
    const double squared = piece.squaredNorm();
    const double t =
        squared > 0.0 ? std::clamp((point_m - line[i - 1]).dot(piece) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (line[i - 1] + t * piece - point_m).norm());
  }
  return nearest;
}

Polyline resampled(const Polyline& line, double step_m) {
  HONKA_CHECK(step_m > 0.0 && !line.empty(), "resampling needs a step and a line");
  Polyline result;
  const double length = length_m(line);
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::round(length / step_m)));
  double before = 0.0;
  std::size_t i = 1;
  for (std::size_t k = 0; k < pieces; ++k) {
    const double along = length * static_cast<double>(k) / static_cast<double>(pieces);
    while (i + 1 < line.size() && before + (line[i] - line[i - 1]).norm() < along) {
      before += (line[i] - line[i - 1]).norm();
      ++i;
    }
    result.push_back(i < line.size() ? point_at({line[i - 1], line[i]}, along - before)
                                     : line.front());
  }
  result.push_back(line.back());
  return result;
}

}  // namespace honka::sim
