#pragma once

#include <cstdint>
#include <vector>

#include "algo/localize/tracking/settings.h"

namespace honka::eval {

/// The tracking experiment: the tracker's own keys and what the drive meets; keys `tracking.*`.
struct TrackingStudySettings {
  TrackingSettings filter;
  std::vector<std::int64_t> frames = {1};
  double localize_every_m = 0.9;
  double second_length_m = 150.0;
  double unmapped_from_m = 90.0;
  double unmapped_length_m = 30.0;
  double unmapped_margin_m = 40.0;
};
void describe(SettingsVisitor& v, TrackingStudySettings& s);

}  // namespace honka::eval
