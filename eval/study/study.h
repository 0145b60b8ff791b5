#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/study/subject.h"
#include "eval/study/trial_record.h"

namespace honka::eval {

/// A study as its scenario asks for it: points × trials, each by every method.
struct Study {
  ResolvedScenario base;           ///< with the axes in base.scenario.study.axes
  std::vector<StudyPoint> points;  ///< values in the order of the axes
  const StudyKind* kind = nullptr;
  std::vector<std::string> methods;
  std::int64_t trials = 0;             ///< at each point
  std::string identity;                ///< SHA-256: studies with equal ones have equal trials
  std::vector<std::string> overrides;  ///< "key=value" as given

  [[nodiscard]] const std::vector<StudyAxis>& axes() const { return base.scenario.study.axes; }
};

/// Reads the scenario of a study; `trials` in place of the file's. UserError at a file without
/// `[study.vary]`, at an experiment that cannot be repeated, and as load_scenario() and
/// load_study_points().
[[nodiscard]] Study load_study(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {},
                               std::optional<std::int64_t> trials = {});

/// "noise 0.3 m" → what a point is called: "sighting.noise_m = 0.3, …".
[[nodiscard]] std::string point_name(const Study& study, std::int64_t point);

/// The command that runs the study, as a user would type it: with overrides and trials.
[[nodiscard]] std::string study_command(const Study& study);

/// The command that runs one trial of a study alone.
[[nodiscard]] std::string replay_command(const Study& study, TrialId id);

/// /trials of trials.h5, one row a trial and method, in (point, trial, method) order. Columns:
/// `point, trial, method`, one an axis (named as its key), `status, cause`, one a measure, and, not
/// in the digest, `wall_s, cpu_s, resident_mb`. Failed trials have NaN measures.
[[nodiscard]] Table study_table(const Study& study, std::vector<TrialRecord> records);

}  // namespace honka::eval
