#include "eval/config/link_study_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, LinkStudySettings& s) {
  describe(v, s.radio);
  v.group("edge", [&] { describe(v, s.edge); });
  v.group("study", [&] {
    v.field({"edge_poses", "", "that the messages carry: the chain of sparse frames, or odometry",
             "Nevalainen2021 sends its chain"},
            s.edge_poses, {"chain", "odometry"});
    v.field({"bandwidth_shares", "", "of the mean need of all key frames",
             "choice; Nevalainen2021 names limited bandwidth and gives none"},
            s.bandwidth_shares, {1e-6, 1e3});
    v.field({"losses", "", "share of messages lost on the air", "choice"}, s.losses, {0.0, 1.0});
    v.field({"delays_s", "s", "between air and cloud", "choice"}, s.delays_s, {0.0, 60.0});
    v.field({"methods", "", "of the cloud, with commas between; honka help slam", "choice"},
            s.methods, {});
  });
}

std::vector<std::string> LinkStudySettings::method_list() const {
  std::vector<std::string> words(1);
  for (const char c : methods) {
    if (c != ',' && c != ' ') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace honka::eval
