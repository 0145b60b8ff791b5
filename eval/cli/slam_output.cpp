#include "eval/cli/slam_output.h"

#include <algorithm>
#include <cmath>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/box_counting.h"
#include "algo/slam/map_quality/clusters.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

SlamJson metric_json_of(double value, const char* unit, std::int64_t n) {
  SlamJson json;
  json["value"] = std::isfinite(value) ? SlamJson(value) : SlamJson(nullptr);
  json["unit"] = unit;
  json["n"] = n;
  return json;
}

}  // namespace

SlamJson map_quality_json(const std::vector<Eigen::Vector3d>& map_m) {
  const auto points = static_cast<std::int64_t>(map_m.size());
  const RegistrationNoise wide = registration_noise(map_m, ClusterSettings{});
  ClusterSettings half;
  half.link_m = 0.5;
  const RegistrationNoise narrow = registration_noise(map_m, half);
  SlamJson json;
  json["blur"] = metric_json_of(blur(map_m, {}), "1", points);
  json["box_dimension"] = metric_json_of(box_dimension(map_m, {}), "1", points);
  json["cluster_rmse_m"] = metric_json_of(wide.mean_rmse_m, "m", wide.clusters);
  json["cluster_rmse_pooled_m"] = metric_json_of(wide.pooled_rmse_m, "m", wide.points);
  json["cluster_rmse_link_0.5_m"] = metric_json_of(narrow.mean_rmse_m, "m", narrow.clusters);
  return json;
}

SlamJson frame_status_json(const std::vector<SparseFrame>& frames,
                           const std::vector<FrameStatus>& statuses) {
  SlamJson counts = SlamJson::object(), not_placed = SlamJson::array();
  for (const FrameStatus status : {FrameStatus::kPlaced, FrameStatus::kUnverified,
                                   FrameStatus::kTooFewPoints, FrameStatus::kNotFinite}) {
    counts[std::string(frame_status_name(status))] =
        std::count(statuses.begin(), statuses.end(), status);
  }
  for (std::size_t l = 0; l < frames.size(); ++l) {
    if (statuses[l] == FrameStatus::kPlaced) continue;
    not_placed.push_back({{"frame", frames[l].number}, {"status", frame_status_name(statuses[l])}});
  }
  SlamJson json;
  json["counts"] = std::move(counts);
  json["not_placed"] = std::move(not_placed);
  return json;
}

std::string map_stems_csv(const std::vector<MapStem>& map_stems) {
  std::string text = "x_m,y_m,z_m,observations,rmse_m\n";
  for (const MapStem& stem : map_stems) {
    const Eigen::Vector3d& p = stem.position_in_first_m;
    for (const double value : {p.x(), p.y(), p.z()}) text.append(exact_text(value)).append(",");
    text.append(std::to_string(stem.observations)).append(",");
    text.append(exact_text(stem.rmse_m)).append("\n");
  }
  return text;
}

std::vector<TimedPose> frame_poses_in_time(const std::vector<SparseFrame>& frames,
                                           const FramePoses& T_first_frame) {
  std::vector<TimedPose> poses;
  for (std::size_t l = 0; l < frames.size(); ++l) {
    poses.push_back({static_cast<double>(frames[l].number), T_first_frame[l]});
  }
  return poses;
}

}  // namespace honka::eval
