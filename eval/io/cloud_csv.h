#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace honka::eval {

/// Reads a sparse cloud: a header with x_m, y_m and, if it likes, z_m (or x, y, z), in any order;
/// other columns are ignored; '#' begins a comment line. Without heights, or where a cell of theirs
/// is empty, z is 0. Metres. A header alone is a cloud of no points.
///
/// UserError "file:line:column: …" for a missing file, header or column, a cell that is no finite
/// number, or a row of another width.
[[nodiscard]] std::vector<Eigen::Vector3d> read_cloud_csv(const std::filesystem::path& path);

}  // namespace honka::eval
