#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "algo/slam/slam.h"
#include "eval/io/tum.h"

namespace honka::eval {

using SlamJson = nlohmann::ordered_json;

/// β, e_C with both links, and the box dimension of a map of all points.
[[nodiscard]] SlamJson map_quality_json(const std::vector<Eigen::Vector3d>& map_m);

/// How many frames have each status, and which are not placed.
[[nodiscard]] SlamJson frame_status_json(const std::vector<SparseFrame>& frames,
                                         const std::vector<FrameStatus>& statuses);

/// stems.csv: x_m,y_m,z_m,observations,rmse_m.
[[nodiscard]] std::string map_stems_csv(const std::vector<MapStem>& map_stems);

/// Poses with the number of the frame as time.
[[nodiscard]] std::vector<TimedPose> frame_poses_in_time(const std::vector<SparseFrame>& frames,
                                                         const FramePoses& T_first_frame);

struct SlamArguments;

/// `honka slam` with other vehicles: one map of all that could be joined.
int slam_fleet(const SlamArguments& arguments);

}  // namespace honka::eval
