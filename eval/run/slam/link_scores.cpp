#include "eval/run/slam/link_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace honka::eval {
namespace {

std::vector<double> known_values(const std::vector<LinkRow>& rows,
                                 const LinkScores::Figure& figure) {
  std::vector<double> values;
  for (const LinkRow& row : rows) {
    const double value = figure(row);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

bool belongs_to(const LinkRow& row, const LinkScores& scores) {
  const LinkCase& a = row.link;
  const LinkCase& b = scores.link;
  return a.series == b.series && a.variant == b.variant && a.value == b.value &&
         row.method == scores.method;
}

}  // namespace

double LinkScores::mean_of(const Figure& figure) const {
  return mean(known_values(trials, figure)).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<Interval> LinkScores::interval_of(const Figure& figure) const {
  return bootstrap_mean(known_values(trials, figure));
}

std::int64_t LinkScores::mapped() const {
  return std::count_if(trials.begin(), trials.end(),
                       [](const LinkRow& row) { return row.status == "mapped"; });
}

std::vector<LinkScores> link_scores(const std::vector<LinkTrial>& trials) {
  std::vector<LinkScores> all;
  for (const LinkTrial& trial : trials) {
    for (const LinkRow& row : trial.rows) {
      auto known = std::find_if(all.begin(), all.end(),
                                [&](const LinkScores& s) { return belongs_to(row, s); });
      if (known == all.end()) known = all.insert(all.end(), {row.link, row.method, {}});
      known->trials.push_back(row);
    }
  }
  return all;
}

}  // namespace honka::eval
