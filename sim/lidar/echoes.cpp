#include "sim/lidar/echoes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algo/types/check.h"
#include "algo/types/user_error.h"

namespace honka::sim {

std::vector<SubRay> footprint(int sub_rays, double horizontal_mrad, double vertical_mrad) {
  // A full 1/e² divergence spans four standard deviations; the outer nodes of the three-point
  // Gauss–Hermite rule lie at √3 of them, inside the footprint.
  const double h = 1e-3 * horizontal_mrad / 4.0 * std::sqrt(3.0);
  const double v = 1e-3 * vertical_mrad / 4.0 * std::sqrt(3.0);
  if (sub_rays == 1) return {{}};
  if (sub_rays == 5) {
    return {{0, 0, 1.0 / 3}, {h, 0, 1.0 / 6}, {-h, 0, 1.0 / 6}, {0, v, 1.0 / 6}, {0, -v, 1.0 / 6}};
  }
  if (sub_rays != 9) {
    throw UserError("lidar.sub_rays: " + std::to_string(sub_rays) + " rays a shot; use 1, 5 or 9");
  }
  std::vector<SubRay> rays;
  for (const int i : {0, 1, -1}) {
    for (const int j : {0, 1, -1}) {
      rays.push_back({i * h, j * v, (i == 0 ? 2.0 / 3 : 1.0 / 6) * (j == 0 ? 2.0 / 3 : 1.0 / 6)});
    }
  }
  return rays;
}

int form_echoes(std::span<SubHit> hits, double resolution_m, Echoes& echoes) {
  std::sort(hits.begin(), hits.end(),
            [](const SubHit& a, const SubHit& b) { return a.range_m < b.range_m; });
  int count = 0;
  for (std::size_t i = 0; i < hits.size(); ++count) {
    Echo& echo = echoes[static_cast<std::size_t>(count)];
    echo = {};
    const double first_m = hits[i].range_m;
    double moment = 0.0, largest = -1.0;
    for (; i < hits.size() && hits[i].range_m - first_m <= resolution_m; ++i) {
      const SubHit& hit = hits[i];
      const double energy = hit.brightness / (hit.range_m * hit.range_m);
      echo.energy += energy;
      echo.brightness += hit.brightness;
      moment += energy * hit.range_m;
      if (energy > largest) {
        largest = energy;
        echo.exact_range_m = hit.range_m;
        echo.label = hit.label;
      }
    }
    echo.range_m = echo.energy > 0.0 ? moment / echo.energy : first_m;
  }
  return count;
}

ReturnMode return_mode(std::string_view name) {
  if (name == "strongest") return ReturnMode::kStrongest;
  if (name == "last") return ReturnMode::kLast;
  if (name == "dual") return ReturnMode::kDual;
  throw UserError("lidar.return_mode: \"" + std::string(name) +
                  "\" is unknown; use strongest, last or dual");
}

Reported reported(const Echoes& echoes, int count, ReturnMode mode) {
  HONKA_CHECK(count >= 1, "nothing to report");
  const int last = count - 1;
  if (mode == ReturnMode::kLast) return {last, last};
  const auto strongest_but = [&](int but) {
    int best = -1;
    for (int i = 0; i < count; ++i) {
      if (i == but) continue;
      if (best < 0 || echoes[static_cast<std::size_t>(i)].energy >
                          echoes[static_cast<std::size_t>(best)].energy) {
        best = i;
      }
    }
    return best;
  };
  const int strongest = strongest_but(-1);
  if (mode == ReturnMode::kStrongest) return {strongest, strongest};
  if (strongest != last) return {strongest, last};
  return {strongest, count > 1 ? strongest_but(last) : last};
}

}  // namespace honka::sim
