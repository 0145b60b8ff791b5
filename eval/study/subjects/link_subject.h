#pragma once

#include "eval/study/subject.h"

namespace honka::eval {

/// `experiment = "link"`: the key frames of a drive sent over one radio link, and what each SLAM
/// method makes of those that arrive.
[[nodiscard]] StudyKind link_study_kind();

}  // namespace honka::eval
