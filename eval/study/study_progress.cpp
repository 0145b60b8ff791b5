#include "eval/study/study_progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/metrics/statistics.h"

namespace honka::eval {

StudyProgress::StudyProgress(const Study& study, const std::string& what, std::int64_t to_do)
    : points_(study.points.size(), {0, 0, std::vector<std::int64_t>(study.methods.size(), 0)}),
      to_do_(to_do),
      progress_(what, "trials", to_do) {}

void StudyProgress::count(const TrialRecord& record) {
  Tally& tally = points_.at(static_cast<std::size_t>(record.id.point));
  ++tally.trials;
  if (record.status != TrialStatus::kDone) ++tally.failed;
  for (std::size_t m = 0; m < record.results.size() && m < tally.holds.size(); ++m) {
    if (record.results[m].values.front() == 1.0) ++tally.holds[m];
  }
}

void StudyProgress::advance(const TrialRecord& record) {
  count(record);
  progress_.remark(remark());
  progress_.advance();
}

void StudyProgress::skip() { progress_.set_total(--to_do_); }

std::string StudyProgress::remark() const {
  double widest = 0.0;
  std::int64_t fewest = 0, failed = 0;
  for (const Tally& tally : points_) {
    failed += tally.failed;
    if (tally.trials == 0) continue;
    fewest = fewest == 0 ? tally.trials : std::min(fewest, tally.trials);
    for (const std::int64_t holds : tally.holds) {
      const auto interval = wilson_interval(holds, tally.trials);
      widest = std::max(widest, 0.5 * (interval->high - interval->low));
    }
  }
  constexpr double kPercent = 100.0;
  std::string text = fmt::format("±{:.1f} % after {} {} at a point", kPercent * widest, fewest,
                                 fewest == 1 ? "trial" : "trials");
  if (failed > 0) text += fmt::format(", {} failed", failed);
  return text;
}

}  // namespace honka::eval
