#pragma once

#include <filesystem>
#include <string>

#include "eval/report/report_model.h"
#include "eval/study/study_json.h"

namespace honka::eval {

/// The first rate over two axes, a heat map a method, each cell with its interval.
[[nodiscard]] ReportFigure draw_rate_map(const std::filesystem::path& folder, const Study& study,
                                         const StudySummary& summary);

/// Half of the widest interval of the first rate by trials.
[[nodiscard]] ReportFigure draw_convergence(const std::filesystem::path& folder, const Study& study,
                                            const Convergence& convergence);

/// "200 trials a point".
[[nodiscard]] std::string trials_text(const Convergence& convergence);

}  // namespace honka::eval
