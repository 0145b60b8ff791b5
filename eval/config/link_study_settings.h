#pragma once

#include <string>
#include <vector>

#include "algo/slam/exchange/edge_sender.h"
#include "algo/types/settings.h"
#include "sim/link/link_settings.h"

namespace honka::eval {

/// The link that every series of the bandwidth study starts from, and what the series vary; keys
/// `link.*`.
struct LinkStudySettings {
  sim::LinkSettings radio;
  EdgeSettings edge;
  std::string edge_poses = "chain";
  std::vector<double> bandwidth_shares = {1.0, 0.3, 0.1, 0.03};
  std::vector<double> losses = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
  std::vector<double> delays_s = {0.0, 1.0, 10.0, 60.0};
  std::string methods = "chain, pose_graph";

  /// The words of `methods`.
  [[nodiscard]] std::vector<std::string> method_list() const;
};
void describe(SettingsVisitor& v, LinkStudySettings& s);

}  // namespace honka::eval
