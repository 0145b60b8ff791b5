#pragma once

#include <filesystem>
#include <string>

#include "eval/io/context.h"
#include "eval/io/table.h"
#include "eval/study/study.h"

namespace honka::eval {

/// What a study tells its user at the end.
struct StudyOutcome {
  std::string table;  ///< for the terminal
  std::string digest;
};

/// Writes summary.json, trials.h5, report.html and figures/ into a folder, each safely, from the
/// rows of study_table(). The digits of all but the context depend on the study and the rows alone.
[[nodiscard]] StudyOutcome write_study_results(const Study& study, const Table& trials,
                                               const Context& context,
                                               const std::filesystem::path& folder,
                                               const std::string& command);

}  // namespace honka::eval
