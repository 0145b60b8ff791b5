#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "algo/types/stem.h"
#include "eval/report/report_model.h"

namespace honka::eval {

/// The stand from above: world frame, metres.
struct StandFigure {
  StemMap stems;
  std::vector<std::vector<Eigen::Vector2d>> roads;  ///< strip roads of the prior run
  std::vector<Eigen::Vector2d> work_path;           ///< the drive that is localized
  std::vector<Eigen::Vector2d> window_starts;
  std::string protocol;
};

[[nodiscard]] ReportFigure draw_stand(const std::filesystem::path& folder,
                                      const StandFigure& input);

}  // namespace honka::eval
