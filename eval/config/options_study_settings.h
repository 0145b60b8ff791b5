#pragma once

#include <cstdint>
#include <vector>

#include "algo/types/settings.h"
#include "sim/sighting/settings.h"

namespace honka::eval {

/// The options of li2020 beside its literal form; keys `options.*`.
struct OptionsStudySettings {
  std::int64_t queries = 300;
  double border_m = 30.0;
  double gnss_sigma_m = 5.0;
  std::vector<double> prior_radii_m = {15.0, 50.0, 150.0};
  std::vector<double> local_radii_m = {15.0, 20.0, 25.0};
  std::vector<double> submap_sizes_m = {120.0, 180.0};
  std::vector<double> slopes_deg = {0.0, 10.0, 20.0, 30.0};
  double height_noise_m = 0.1;
  sim::SightingSettings list;
};
void describe(SettingsVisitor& v, OptionsStudySettings& s);

}  // namespace honka::eval
