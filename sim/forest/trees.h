#pragma once

#include <cstdint>
#include <vector>

#include "algo/types/settings.h"
#include "algo/types/stem.h"
#include "sim/forest/stand.h"

namespace honka::sim {

struct TreeSettings {
  double dbh_shape = 3.75;
  double dbh_scale_m = 0.205;
  double dbh_min_m = 0.05;
  double naslund_a = 1.3;
  double naslund_b = 0.19;
  double height_residual_m = 2.0;
  double lean_sd_deg = 1.5;
  double crown_base_low = 0.5;
  double crown_base_high = 0.6;
  double spruce_share = 0.0;
};
void describe(SettingsVisitor& v, TreeSettings& s);

/// Näslund's height curve: 1.3 + d² / (a + b d)², d in centimetres. Metres.
[[nodiscard]] double naslund_height_m(const TreeSettings& settings, double dbh_m);

/// The tree `id` at a place: what `known` gives (DBH, height) is kept, the rest is drawn from
/// streams that belong to `id`. `base_m` lies on the ground.
[[nodiscard]] Tree grow_tree(const TreeSettings& settings, std::int32_t id,
                             const Eigen::Vector3d& base_m, const Stem& known, std::uint64_t seed);

/// Settings whose DBH distribution has the mean and variance of the stems' measured DBHs, and whose
/// height curve is fitted to the measured heights; what too few were measured of stays as it is.
[[nodiscard]] TreeSettings fitted_to(const TreeSettings& settings, const StemMap& stems);

/// Shape of the Weibull distribution with a coefficient of variation (s.d. / mean).
[[nodiscard]] double weibull_shape_of_variation(double variation);

}  // namespace honka::sim
