#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algo/types/pose.h"

namespace honka::test {

/// Where the shared SLAM reference case lies; nothing where the folder is absent.
[[nodiscard]] std::optional<std::filesystem::path> shared_slam_cases();

/// Rows of numbers of a CSV file, also of a gzipped one. Rows whose first character is a letter
/// (headers) and `#` comments are left out.
[[nodiscard]] std::vector<std::vector<double>> read_number_rows(const std::filesystem::path& file);

/// Points of each frame, in the lidar's frame; frame numbers 0, 1, 2 … Metres.
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> read_frame_points(
    const std::filesystem::path& file);

/// Poses from 12 numbers a row, [R|p] by rows, the first of them in column `first`.
[[nodiscard]] std::vector<Pose3> read_pose_rows(const std::filesystem::path& file,
                                                std::size_t first = 0);

}  // namespace honka::test
