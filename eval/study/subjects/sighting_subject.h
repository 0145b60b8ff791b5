#pragma once

#include "eval/study/subject.h"

namespace honka::eval {

/// `experiment = "sighting"`: one list of stems, without rays, found in the map of a forest.
[[nodiscard]] StudyKind sighting_study_kind();

/// The measures of every kind of trial in which one list or window is localized: success, wrong,
/// refused (rates), the errors of successes, their bound, and the time of matching.
[[nodiscard]] std::vector<Measure> localization_measures();

}  // namespace honka::eval
