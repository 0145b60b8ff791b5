#include "eval/study/point_ends.h"

#include <algorithm>

#include "eval/study/stop_rule.h"

namespace honka::eval {

PointEnds::PointEnds(const Study& study)
    : methods_(study.methods.size()),
      half_width_(study.base.scenario.study.stop_half_width),
      points_(study.points.size()),
      ends_(study.points.size(), study.trials) {
  if (half_width_ <= 0.0) return;
  const auto trials = static_cast<std::size_t>(study.trials);
  for (Point& point : points_) {
    point.holds.assign(methods_, std::vector<std::uint8_t>(trials, 0));
    point.known.assign(trials, 0);
  }
}

void PointEnds::add(TrialId id, const std::vector<std::uint8_t>& holds) {
  if (half_width_ <= 0.0) return;
  Point& point = points_.at(static_cast<std::size_t>(id.point));
  const auto trial = static_cast<std::size_t>(id.trial);
  if (trial >= point.known.size()) return;
  for (std::size_t m = 0; m < methods_; ++m) point.holds[m][trial] = holds.at(m);
  point.known[trial] = 1;
  const std::int64_t before = point.without_gap / kStopLook;
  while (point.without_gap < static_cast<std::int64_t>(point.known.size()) &&
         point.known[static_cast<std::size_t>(point.without_gap)] != 0) {
    ++point.without_gap;
  }
  if (point.without_gap / kStopLook == before) return;
  std::vector<std::vector<std::uint8_t>> first = point.holds;
  for (auto& of_method : first) of_method.resize(static_cast<std::size_t>(point.without_gap));
  std::int64_t& end = ends_[static_cast<std::size_t>(id.point)];
  end = std::min(end, stopped_after(first, half_width_).value_or(end));
}

void PointEnds::add(const TrialRecord& record) {
  std::vector<std::uint8_t> holds(methods_, 0);
  for (std::size_t m = 0; m < record.results.size() && m < methods_; ++m) {
    holds[m] = record.results[m].values.front() == 1.0 ? 1 : 0;
  }
  add(record.id, holds);
}

}  // namespace honka::eval
