#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "algo/types/pose.h"

namespace honka::test {

/// Columns x_m, y_m of a stem CSV: `#` comments, a header, numbers.
[[nodiscard]] std::vector<Eigen::Vector2d> read_stems(const std::filesystem::path& file);

/// A row of poses.csv of the localization cases.
struct CasePose {
  std::string name;
  int frames = 0;
  Pose2 T_map_local;
};

[[nodiscard]] std::vector<CasePose> read_case_poses(const std::filesystem::path& file);

}  // namespace honka::test
