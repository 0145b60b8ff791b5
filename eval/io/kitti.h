#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "algo/types/pose.h"

namespace honka::eval {

/// Reads KITTI rows, 12 numbers each: [R|t] of a pose by rows, blanks between; the row's number
/// from 0 is its time. A matrix within 1e-2 of orthonormal becomes the nearest rotation; one that
/// is orthonormal to 1e-12 stays as it is. UserError "file:line:column: …" for a missing file, a
/// row of another width, a cell that is no finite number, a matrix that is no rotation, or no
/// poses.
[[nodiscard]] std::vector<Pose3> read_kitti(const std::filesystem::path& path);

/// The same rows in a text that came from `path`, separated by commas or by blanks.
[[nodiscard]] std::vector<Pose3> read_pose_rows(const std::filesystem::path& path,
                                                std::string_view text);

/// Writes KITTI rows at full precision: read_kitti gives the same poses back. Written safely.
void write_kitti(const std::filesystem::path& path, const std::vector<Pose3>& poses);

}  // namespace honka::eval
