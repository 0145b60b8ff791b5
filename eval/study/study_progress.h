#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/run/progress.h"
#include "eval/study/study.h"

namespace honka::eval {

/// Tells how far a study has come: trials, time left, failures, and how wide the widest interval
/// of its first rate still is.
class StudyProgress {
 public:
  StudyProgress(const Study& study, const std::string& what, std::int64_t to_do);

  /// A trial that is known already.
  void count(const TrialRecord& record);
  /// A trial that has just ended.
  void advance(const TrialRecord& record);
  /// A trial that is not needed any more.
  void skip();

 private:
  /// "±1.2 % after 800 trials a point, 3 failed"
  [[nodiscard]] std::string remark() const;

  struct Tally {
    std::int64_t trials = 0, failed = 0;
    std::vector<std::int64_t> holds;  ///< by method
  };
  std::vector<Tally> points_;
  std::int64_t to_do_;
  Progress progress_;
};

}  // namespace honka::eval
