#pragma once

#include "sim/forest/stand.h"

namespace honka::sim {

/// Stem diameter over that at a fifth of the height, d(x) / d(0.2 h), at x = 1 − height / tree
/// height in [0, 1]. Laasasenaho 1982, with x^p over p = 1, 2, 3, 5, 8, 13, 21, 34.
[[nodiscard]] double taper_ratio(Species species, double x);

/// Volume of the stem over bark from the ground to the top. Cubic metres.
[[nodiscard]] double stem_volume_m3(const Tree& tree);

}  // namespace honka::sim
