#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/slam/selection_trial.h"

namespace honka::eval {

/// Fig. 9: e of judged pairs over λ, with the line of Eq. 27; one panel a test.
[[nodiscard]] ReportFigure draw_pair_errors(const std::filesystem::path& folder,
                                            const std::vector<SelectionCase>& cases);

/// Fig. 10: the (j, i) plane with the promising pairs and the chosen ones.
[[nodiscard]] ReportFigure draw_pair_choice(const std::filesystem::path& folder,
                                            const SelectionCase& c);

}  // namespace honka::eval
