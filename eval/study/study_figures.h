#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/study/study_json.h"

namespace honka::eval {

/// Draws a study into a folder: the first rate over what varies, with its intervals, for every
/// method (two axes: a heat map too), each error beside its bound, times, memory, and how the
/// widest interval narrowed. The first axis runs along x; with two or more there is a panel a
/// method and a curve a value of the second; further axes make figures of their own, some of them.
[[nodiscard]] std::vector<ReportFigure> draw_study_figures(const std::filesystem::path& folder,
                                                           const Study& study,
                                                           const StudySummary& summary);

}  // namespace honka::eval
