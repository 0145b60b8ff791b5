#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "eval/config/scenario.h"

namespace honka::eval {

/// What statistics and figures make of a number that each trial gives.
enum class MeasureKind {
  kRate,   ///< 0 or 1: a share of all trials, failed ones counting as 0
  kError,  ///< pooled as an RMSE over the trials where it is finite
  kValue,  ///< its mean over the trials where it is finite
  kTime,   ///< its median and 95th percentile; differs from run to run, so not in the digest
};

/// One number that a trial gives for each method.
struct Measure {
  std::string name;       ///< of its column: "translation_error_m"
  std::string unit;       ///< empty for shares and counts
  std::string long_name;  ///< of its axis in figures: "Error of the position"
  MeasureKind kind = MeasureKind::kValue;
  bool less_is_better = true;
};

/// What one method made of one trial: its measures in the order of StudyKind::measures, NaN where
/// a measure does not apply (the error of a refused answer).
struct MethodResult {
  std::string method;
  std::vector<double> values;

  bool operator==(const MethodResult&) const = default;
};

/// What a study repeats at one point: trials that share worlds. One thread at a time.
class StudySubject {
 public:
  virtual ~StudySubject() = default;
  /// One result a method, in the order of StudyKind::methods. The digits depend on (scenario,
  /// trial) alone: not on what ran before, nor on threads. Every method gets the same input, and
  /// trial t has the same forest, places and noise draws at every point, as far as the varied keys
  /// allow (common random numbers). Trial t belongs to the world t mod study.worlds, which is kept
  /// until a trial of another world is asked for. What it throws makes a failed trial.
  [[nodiscard]] virtual std::vector<MethodResult> run(std::int64_t trial) = 0;
};

/// A kind of trial that studies repeat; a new one is one file and one line in subject.cpp.
struct StudyKind {
  std::string experiment;         ///< that a scenario names
  std::string help;               ///< one line
  std::vector<Measure> measures;  ///< the first is a rate: what the optional stop looks at
  std::vector<std::string> (*methods)(const Scenario& scenario);
  std::unique_ptr<StudySubject> (*make)(const Scenario& scenario);
};

[[nodiscard]] const std::vector<StudyKind>& study_kinds();

/// The kind that repeats the scenario's experiment. UserError with the known ones when none does.
[[nodiscard]] const StudyKind& find_study_kind(const ResolvedScenario& resolved);

}  // namespace honka::eval
