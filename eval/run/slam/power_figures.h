#pragma once

#include <filesystem>
#include <vector>

#include "algo/types/pose.h"
#include "eval/report/report_model.h"

namespace honka::eval {

/// Mean errors over the power u: of a power's inverse power, and of 1/u factors.
struct PowerErrors {
  std::vector<Eigen::Vector2d> inverse_power, product;
};

/// Nevalainen2021 Fig. 2: frames as red, green and blue axes.
[[nodiscard]] ReportFigure draw_power_frames(const std::filesystem::path& folder,
                                             const std::vector<Pose3>& frames);

/// Nevalainen2021 Fig. 3, with the paper's error as a dashed line.
[[nodiscard]] ReportFigure draw_power_errors(const std::filesystem::path& folder,
                                             const PowerErrors& errors, double paper_error);

}  // namespace honka::eval
