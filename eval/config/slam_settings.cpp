#include "eval/config/slam_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, SlamKeyFrameSettings& s) {
  v.field({"distance_m", "m", "least way between two key frames, by the edge's odometry",
           "choice: Nevalainen2021 samples frames adaptively and gives no step"},
          s.distance_m, {0.001, 100.0});
  v.field({"angle_deg", "deg", "least turn between two key frames, where the way is shorter",
           "choice, as distance_m"},
          s.angle_deg, {0.1, 180.0});
}

void describe(SettingsVisitor& v, SlamStudySettings& s) {
  v.field({"study", "", "which comparison the experiment makes",
           "Nevalainen2021: Table 1, Figure 11; methods side by side"},
          s.study, {"table1", "methods", "fig11"});
  v.field({"start_inlier_ratios", "", "starts: chains of trimmed ICP with these inlier ratios",
           "Nevalainen2021 gives none; 0.95 has its start's blur"},
          s.start_inlier_ratios, {0.05, 1.0});
  v.field({"start_reregistered", "", "also the chain with its bad steps registered again",
           "choice: the best start at hand"},
          s.start_reregistered);
  v.group("keyframe", [&] { describe(v, s.keyframe); });
}

}  // namespace honka::eval
