#pragma once

#include <cstdint>
#include <vector>

#include "eval/io/table.h"
#include "eval/study/study.h"

namespace honka::eval {

/// How many trials each point of a study has: study.trials, or fewer where the intervals of its
/// first rate have become as narrow as study.stop_half_width asks. That depends on the first
/// trials of the point alone, so it is the same while running and at the merge.
class PointEnds {
 public:
  explicit PointEnds(const Study& study);

  /// A trial that is known: whether each method's first rate holds in it (failed ones: none).
  void add(TrialId id, const std::vector<std::uint8_t>& holds);
  void add(const TrialRecord& record);

  /// Trials from this number on do not count.
  [[nodiscard]] std::int64_t end(std::int64_t point) const {
    return ends_.at(static_cast<std::size_t>(point));
  }

 private:
  struct Point {
    std::vector<std::vector<std::uint8_t>> holds;  ///< [method][trial]
    std::vector<std::uint8_t> known;               ///< by trial
    std::int64_t without_gap = 0;                  ///< trials known from the first on
  };

  std::size_t methods_;
  double half_width_;
  std::vector<Point> points_;
  std::vector<std::int64_t> ends_;
};

}  // namespace honka::eval
