#pragma once

#include <string>

#include "eval/study/study_folder.h"

namespace honka::eval {

/// How far each shard of a study is, what failed and why, and the command to give next; as text.
/// Reads while others write. UserError where the folder holds no study.
[[nodiscard]] std::string study_status(const StudyFolder& folder);

}  // namespace honka::eval
