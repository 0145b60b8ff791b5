#include "eval/config/slam_settings.h"

namespace honka::eval {

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
}

}  // namespace honka::eval
