#include "algo/slam/map_quality/box_counting.h"

#include <cmath>

#include "algo/slam/map_quality/blur.h"

namespace honka {

void describe(SettingsVisitor& v, BoxCountingSettings& s) {
  v.field({"smallest_m", "m", "side of the smallest boxes", "choice: ε1 of the blur"}, s.smallest_m,
          Range{0.001, 100.0});
  v.field({"largest_m", "m", "side of the largest boxes, doubled up to it",
           "choice: below the distance between trees"},
          s.largest_m, Range{0.001, 1000.0});
  v.field({"spatial", "", "boxes in space, not in the plane", "Nevalainen2021 §4"}, s.spatial);
}

double box_dimension(std::span<const Eigen::Vector3d> map_m, const BoxCountingSettings& settings) {
  double n = 0.0, sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (double side_m = settings.smallest_m; side_m <= settings.largest_m * (1.0 + 1e-9);
       side_m *= 2.0) {
    const auto boxes = occupied_grid_points(map_m, side_m, settings.spatial);
    if (boxes == 0) return 0.0;
    const double x = -std::log(side_m), y = std::log(static_cast<double>(boxes));
    n += 1.0;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  const double spread = n * sum_xx - sum_x * sum_x;
  return spread > 0.0 ? (n * sum_xy - sum_x * sum_y) / spread : 0.0;
}

double two_scale_dimension(std::span<const Eigen::Vector3d> map_m, double fine_m, double coarse_m,
                           bool spatial) {
  const auto fine = occupied_grid_points(map_m, fine_m, spatial);
  const auto coarse = occupied_grid_points(map_m, coarse_m, spatial);
  if (coarse == 0 || !(fine_m < coarse_m)) return 0.0;
  return std::log(static_cast<double>(fine) / static_cast<double>(coarse)) /
         std::log(coarse_m / fine_m);
}

}  // namespace honka
