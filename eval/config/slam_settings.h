#pragma once

#include <string>
#include <vector>

#include "algo/types/settings.h"

namespace honka::eval {

/// What the SLAM experiment compares; keys `slam.*` beside those of the method itself.
struct SlamStudySettings {
  std::string study = "table1";
  std::vector<double> start_inlier_ratios = {0.95, 0.4};
  bool start_reregistered = true;
};
void describe(SettingsVisitor& v, SlamStudySettings& s);

}  // namespace honka::eval
