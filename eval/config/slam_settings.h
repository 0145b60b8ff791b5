#pragma once

#include <string>
#include <vector>

#include "algo/types/settings.h"

namespace honka::eval {

/// When the edge keeps a sweep as a key frame; keys `slam.keyframe.*`.
struct SlamKeyFrameSettings {
  double distance_m = 0.25;
  double angle_deg = 3.0;
};
void describe(SettingsVisitor& v, SlamKeyFrameSettings& s);

/// What the SLAM experiment compares; keys `slam.*` beside those of the method itself.
struct SlamStudySettings {
  std::string study = "table1";
  std::vector<double> start_inlier_ratios = {0.95, 0.4};
  bool start_reregistered = true;
  SlamKeyFrameSettings keyframe;
};
void describe(SettingsVisitor& v, SlamStudySettings& s);

}  // namespace honka::eval
