#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/types/settings.h"

namespace honka {

/// Spacings of the two grids whose occupied parts the blur compares.
struct BlurSettings {
  double fine_m = 0.2;
  double coarse_m = 10.0;
  bool spatial = false;  ///< grids in space with cubed spacings, not in the plane with squared ones
};
void describe(SettingsVisitor& v, BlurSettings& s);

/// |{P}_ε|: how many grid points of spacing `spacing_m` some point of the map rounds to, in the
/// plane or in space. Points that are not finite are left out.
[[nodiscard]] std::int64_t occupied_grid_points(std::span<const Eigen::Vector3d> map_m,
                                                double spacing_m, bool spatial = false);

/// β in (0, 1]: the occupied area of the fine grid over that of the coarse one; smaller is sharper.
/// Infinite for a map without finite points. Source: Nevalainen2021 Eq. 30.
[[nodiscard]] double blur(std::span<const Eigen::Vector3d> map_m, const BlurSettings& settings);

}  // namespace honka
