#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/types/settings.h"
#include "eval/config/toml_source.h"

namespace honka::eval {

/// A key that a study varies, with its values in order.
struct StudyAxis {
  std::string key;  ///< of the scenario: "sighting.noise_m"
  std::vector<Value> values;
  std::string place;  ///< where the scenario says so
};

/// A Monte Carlo study: many trials at each point; keys `study.*`, and `study.vary.KEY` for what
/// varies.
struct StudySettings {
  std::int64_t trials = 200;
  std::int64_t worlds = 4;
  std::string combine = "grid";
  double time_limit_s = 600.0;
  std::int64_t memory_limit_mb = 0;
  double stop_half_width = 0.0;
  std::vector<StudyAxis> axes;     ///< in the order of the file
  std::vector<std::string> fixed;  ///< keys that vary in the file, set by the command line

  /// Whether the scenario is one of many trials at points.
  [[nodiscard]] bool asked_for() const { return !axes.empty() || !fixed.empty(); }
};
void describe(SettingsVisitor& v, StudySettings& s);

/// Takes `study.vary.*` out of the values of a scenario file, in the order of the file. A text may
/// hold several words, "strauss, rows". A key that the command line sets is no axis but `fixed`.
/// UserError at an empty list.
void take_axes(LocatedValues& values, StudySettings& settings);

/// The points of a study, one value an axis: every combination ("grid", the last axis fastest), or
/// the k-th values together ("list"). UserError where lists differ in length.
[[nodiscard]] std::vector<std::vector<Value>> study_points(const StudySettings& settings);

}  // namespace honka::eval
