#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/statistics.h"
#include "eval/run/slam/link_trial.h"

namespace honka::eval {

/// The rows of one link and method, one a trial.
struct LinkScores {
  LinkCase link;
  std::string method;
  std::vector<LinkRow> trials;

  using Figure = std::function<double(const LinkRow&)>;
  /// Mean of a figure over the trials that have it; NaN where none has.
  [[nodiscard]] double mean_of(const Figure& figure) const;
  /// Bootstrap over the trials, 95 %; nothing for fewer than two.
  [[nodiscard]] std::optional<Interval> interval_of(const Figure& figure) const;
  /// Trials in which a map came about.
  [[nodiscard]] std::int64_t mapped() const;
};

/// Gathers the rows of several trials, in the order of the first.
[[nodiscard]] std::vector<LinkScores> link_scores(const std::vector<LinkTrial>& trials);

}  // namespace honka::eval
