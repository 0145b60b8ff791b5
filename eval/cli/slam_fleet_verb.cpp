#include <fmt/format.h>

#include "algo/slam/fleet.h"
#include "algo/types/user_error.h"
#include "eval/cli/slam_output.h"
#include "eval/cli/verbs.h"
#include "eval/io/context.h"
#include "eval/io/frames_csv.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace {

std::vector<std::filesystem::path> fleet_files(const SlamArguments& arguments) {
  std::vector<std::filesystem::path> files = {arguments.frames};
  files.insert(files.end(), arguments.vehicles.begin(), arguments.vehicles.end());
  return files;
}

/// trajectory.tum of the first vehicle, trajectory_2.tum of the second, and so on.
std::string trajectory_name(std::size_t vehicle) {
  return vehicle == 0 ? "trajectory.tum" : fmt::format("trajectory_{}.tum", vehicle + 1);
}

SlamJson vehicle_json(const std::filesystem::path& file, const VehicleDrive& drive,
                      const VehicleMap& map, std::size_t vehicle) {
  SlamJson json;
  json["frames_file"] = file.string();
  json["trajectory"] = trajectory_name(vehicle);
  json["joined"] = map.joined;
  json["joins"] = map.joins;
  json["frames"] = frame_status_json(drive.frames, map.frames);
  return json;
}

SlamJson fleet_json(const SlamArguments& arguments, const std::vector<VehicleDrive>& drives,
                    const FleetResult& result, const Context& context) {
  const auto files = fleet_files(arguments);
  std::vector<Eigen::Vector3d> map_m;
  SlamJson json;
  json["schema_version"] = kResultsSchemaVersion;
  json["context"] = context.entries();
  json["method"] = arguments.method;
  json["vehicles"] = SlamJson::array();
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const VehicleMap& map = result.vehicles[k];
    json["vehicles"].push_back(vehicle_json(files[k], drives[k], map, k));
    if (!map.joined) continue;
    for (const Eigen::Vector3d& p : map_points(drives[k].frames, map.T_map_frame)) {
      map_m.push_back(p);
    }
  }
  json["metrics"] = map_quality_json(map_m);
  json["stems"] = result.stems.size();
  return json;
}

}  // namespace

int slam_fleet(const SlamArguments& arguments) {
  OutputFolder folder(arguments.out);
  const Context context(1, 0);
  std::vector<VehicleDrive> drives;
  for (const auto& file : fleet_files(arguments)) drives.push_back({read_frames_csv(file), {}});
  if (!arguments.chain.empty()) {
    drives[0].T_first_frame_chain = read_chain_poses(arguments.chain, drives[0].frames);
  }

  SlamSettings settings;
  settings.method = arguments.method;
  settings.pairs.propose = arguments.propose;
  const FleetResult result = run_fleet(drives, settings, FleetSettings{});

  std::size_t joined = 0;
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const VehicleMap& map = result.vehicles[k];
    joined += map.joined ? 1 : 0;
    write_tum(folder.path() / trajectory_name(k),
              frame_poses_in_time(drives[k].frames, map.T_map_frame));
  }
  write_file_safely(folder.path() / "stems.csv", map_stems_csv(result.stems));
  write_file_safely(folder.path() / "summary.json",
                    fleet_json(arguments, drives, result, context).dump(2) + "\n");
  folder.commit();
  fmt::print("{}: {} of {} vehicles in one map, {} stems\n", folder.final_path().string(), joined,
             drives.size(), result.stems.size());
  return 0;
}

}  // namespace honka::eval
