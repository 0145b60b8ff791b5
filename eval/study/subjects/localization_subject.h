#pragma once

#include "eval/study/subject.h"

namespace honka::eval {

/// `experiment = "localization"`: one window of key frames, rays included, found in the trunk map
/// of its forest.
[[nodiscard]] StudyKind localization_study_kind();

}  // namespace honka::eval
