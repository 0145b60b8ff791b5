#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/slam/frame_scores.h"
#include "eval/run/slam/slam_drive.h"
#include "eval/run/slam/slam_quality.h"

namespace honka::eval {

/// What one treatment made of one drive from one start.
struct SlamRun {
  std::string start;      ///< chain_0.95 | chain_0.4 | reregistered | edge | true_poses
  std::string treatment;  ///< none, an order of the paper's loop, or a method
  FramePoses T_first_frame;
  SlamQuality quality;
  std::int64_t corrections = 0;  ///< corrective matches that were put in
  std::int64_t candidates = 0;   ///< pairs that they were chosen from
  std::int64_t icp_calls = 0, go_icp_calls = 0;
  double time_s = 0.0;    ///< wall clock of the treatment, its start not counted
  double go_icp_s = 0.0;  ///< of it in Go-ICP
  double icp_s = 0.0;     ///< and in ICP of corrective matches
};

/// One drive with all that was made of it. Without frames it failed, and has no runs.
struct SlamTrial {
  std::int64_t trial = 0;
  SlamDrive drive;
  FrameScores stems;
  SlamQuality floor;  ///< of the map at true poses
  std::vector<SlamRun> runs;
};

/// The treatments that the scenario's study asks for, as (start, treatment), in the order of rows.
struct SlamCase {
  std::string start, treatment;
};
[[nodiscard]] std::vector<SlamCase> slam_cases(const Scenario& scenario);

/// Runs every case of the study on a drive. The digits depend on the drive, the scenario and the
/// trial alone, whatever the threads.
[[nodiscard]] SlamTrial run_slam_trial(SlamDrive drive, const Scenario& scenario,
                                       std::int64_t trial, int threads);

}  // namespace honka::eval
