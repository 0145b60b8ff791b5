#include "eval/run/slam/link_trial.h"

#include <chrono>

#include "algo/slam/chain.h"
#include "algo/slam/exchange/cloud_map.h"
#include "algo/types/random.h"
#include "eval/run/parallel.h"

namespace honka::eval {
namespace {}  // namespace

FramePoses edge_poses_of(const SlamDrive& drive, const Scenario& scenario) {
  if (scenario.link.edge_poses == "odometry") return drive.edge_T_first_frame;
  return make_chain(drive.frames, scenario.slam.chain).T_first_frame;
}

LinkMapQuality link_floor(const SlamDrive& drive, std::span<const SparseFrame> frames,
                          const SlamSettings& settings) {
  if (frames.empty()) return {};
  FramePoses T_first_frame;
  const auto first = static_cast<std::size_t>(frames.front().number);
  const Pose3 T_first_truth = drive.true_T_first_frame[first].inverse();
  for (const SparseFrame& frame : frames) {
    const auto number = static_cast<std::size_t>(frame.number);
    T_first_frame.push_back(T_first_truth * drive.true_T_first_frame[number]);
  }
  const StemMap3 stems = build_stem_map(frames, T_first_frame, settings.stem_map);
  return judge_link_map(drive, frames, T_first_frame, stems.stems);
}

std::uint64_t link_seed(const Scenario& scenario, std::int64_t trial) {
  return derive_seed(scenario.seed, "link", {static_cast<std::uint64_t>(trial)});
}

void map_over_link(const SlamDrive& drive, const ReceivedFrames& received, SlamSettings settings,
                   LinkRow& row) {
  settings.method = row.method;
  const auto start = std::chrono::steady_clock::now();
  const CloudMap cloud = map_received(received, settings);
  row.map_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  row.status = cloud_map_status_name(cloud.status);
  if (cloud.status != CloudMapStatus::kMapped) return;
  row.quality = judge_link_map(drive, received.frames(), cloud.map.T_first_frame, cloud.map.stems);
}

LinkTrial study_links(const SlamDrive& drive, const Scenario& scenario, std::int64_t trial,
                      int threads) {
  const LinkStudySettings& settings = scenario.link;
  const double firing_s = vlp16(scenario.lidar.rotation_rate_hz).firing_period_s;
  LinkTrial result;
  result.need = need_of(drive, settings.radio.overhead_bytes, firing_s);

  // 1. Every link carries the same messages' worth of key frames, under the same chances.
  const FramePoses edge_T_first = edge_poses_of(drive, scenario);
  const std::uint64_t seed = link_seed(scenario, trial);
  const auto methods = settings.method_list();
  std::vector<ReceivedFrames> received;
  for (const LinkCase& link : link_cases(settings, result.need)) {
    const LinkOutcome outcome = exchange_drive(drive, edge_T_first, link, seed);
    received.push_back(outcome.cloud.received());
    for (const std::string& method : methods) {
      result.rows.push_back(
          {trial, link, method, "", outcome.tally, {}, {}, result.need.length_m, 0.0});
    }
  }
  // 2. The cloud maps what it received; the truth judges.
  std::vector<LinkMapQuality> floors(received.size());
  for_each_index(received.size(), threads, [&](std::size_t i) {
    floors[i] = link_floor(drive, received[i].frames(), scenario.slam);
  });
  for_each_index(result.rows.size(), threads, [&](std::size_t i) {
    result.rows[i].floor = floors[i / methods.size()];
    map_over_link(drive, received[i / methods.size()], scenario.slam, result.rows[i]);
  });
  return result;
}

}  // namespace honka::eval
