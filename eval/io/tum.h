#pragma once

#include <filesystem>
#include <vector>

#include "algo/types/pose.h"

namespace honka::eval {

struct TimedPose {
  double time_s = 0.0;
  Pose3 pose = Pose3::Identity();  ///< T_world_lidar in our own files
};

/// Reads TUM rows `t x y z qx qy qz qw` (blanks between; '#' comments), in the order of the file.
/// Quaternions within 1e-2 of unit length are normalized. UserError "file:line:column: …" for a
/// missing file, a row of another width, a cell that is no finite number, a quaternion that is
/// none, times that do not increase, or a file without poses.
[[nodiscard]] std::vector<TimedPose> read_tum(const std::filesystem::path& path);

/// A trajectory as a file holds it. Without rotations those of `poses` are the identity and mean
/// nothing.
struct TimedPoses {
  std::vector<TimedPose> poses;
  bool has_rotations = true;
};

/// As read_tum, but all rows may also be positions alone, `t x y z`.
[[nodiscard]] TimedPoses read_tum_trajectory(const std::filesystem::path& path);

/// Writes TUM rows at full precision, with a comment line that names the columns. Written safely.
void write_tum(const std::filesystem::path& path, const std::vector<TimedPose>& poses);

}  // namespace honka::eval
