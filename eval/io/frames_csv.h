#pragma once

#include <filesystem>
#include <vector>

#include "algo/slam/sparse_frame.h"

namespace honka::eval {

/// Reads the stems of key frames: a header with frame, x_m, y_m, z_m (also x, y, z), in any order;
/// other columns are ignored; '#' begins a comment line; gzip is understood. One point a row,
/// metres, in the lidar's frame. Frames come back in rising order of their numbers, which may have
/// gaps; the points of a frame in the order of the file.
///
/// UserError "file:line:column: …" for a missing file, header or column, a row of another width, a
/// cell that is no finite number, a frame that is no whole number, or a file without points.
[[nodiscard]] std::vector<SparseFrame> read_frames_csv(const std::filesystem::path& path);

/// Reads T_first_frame, 12 numbers a frame ([R|p] by rows), without a header, separated by commas
/// or blanks, one row a frame of `frames` in rising order. Where there is one row for each number
/// from 0 to the last frame's, row k is that of frame k, and frames without points are put into
/// `frames` as empty ones. UserError "file:line:column: …" for anything else.
[[nodiscard]] FramePoses read_chain_poses(const std::filesystem::path& path,
                                          std::vector<SparseFrame>& frames);

}  // namespace honka::eval
