#pragma once

#include <filesystem>
#include <vector>

#include "algo/slam/view_cone.h"
#include "eval/report/report_model.h"

namespace honka::eval {

/// How far λ by so many samples is from the area.
struct OverlapError {
  int samples = 0;
  double rms = 0.0, largest = 0.0;
};

/// Nevalainen2021 Fig. 8: both cones from above, what they share in grey.
[[nodiscard]] ReportFigure draw_overlap_cones(const std::filesystem::path& folder,
                                              const Pose2& T_target_source, const ViewCone& cone,
                                              double overlap);

[[nodiscard]] ReportFigure draw_overlap_errors(const std::filesystem::path& folder,
                                               const std::vector<OverlapError>& errors);

}  // namespace honka::eval
