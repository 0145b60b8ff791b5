#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "sim/world/world.h"

namespace honka::sim {

/// One ray of a shot: its angles from the beam's centre and its share of the pulse's energy.
struct SubRay {
  double horizontal_rad = 0.0;  ///< towards growing azimuth
  double vertical_rad = 0.0;    ///< upwards
  double weight = 1.0;
};

inline constexpr int kMostSubRays = 9;

/// 1, 5 or 9 rays over a Gaussian footprint of the given full 1/e² divergences. Weights sum to 1;
/// 5 and 9 have the footprint's exact variances (Gauss–Hermite nodes).
[[nodiscard]] std::vector<SubRay> footprint(int sub_rays, double horizontal_mrad,
                                            double vertical_mrad);

/// What one ray of a shot brings back. Without initializers: nine stand on the stack of each shot.
struct SubHit {
  double range_m;
  double brightness;  ///< weight × reflectivity in percent × cosine of incidence
  Label label;
};

/// What the receiver sees as one return.
struct Echo {
  double range_m = 0.0;        ///< mean over the surfaces that melt into it, by energy
  double brightness = 0.0;     ///< sum over them; percent of a full target at normal incidence
  double energy = 0.0;         ///< brightness / range²
  double exact_range_m = 0.0;  ///< of the surface with the largest share
  Label label;                 ///< of that surface
};

/// The echo of a single hit.
[[nodiscard]] inline Echo only_echo(const SubHit& hit) {
  return {hit.range_m, hit.brightness, hit.brightness / (hit.range_m * hit.range_m), hit.range_m,
          hit.label};
}

using Echoes = std::array<Echo, kMostSubRays>;

/// Melts hits closer than `resolution_m` to the first of their group into one echo. Sorts `hits`
/// by range; fills `echoes` by range and returns how many there are.
int form_echoes(std::span<SubHit> hits, double resolution_m, Echoes& echoes);

enum class ReturnMode { kStrongest, kLast, kDual };

/// The mode that `lidar.return_mode` names. Throws UserError for unknown names.
[[nodiscard]] ReturnMode return_mode(std::string_view name);

/// Indices into the echoes of what is reported first and second (dual only): the strongest or the
/// last; in dual mode the strongest and the last, or the second strongest where the strongest is
/// the last, or twice the only one (VLP-16 manual 63-9243). `count` at least 1.
struct Reported {
  int first = 0;
  int second = 0;
};
[[nodiscard]] Reported reported(const Echoes& echoes, int count, ReturnMode mode);

}  // namespace honka::sim
