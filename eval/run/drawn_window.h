#pragma once

#include <cstdint>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/drive.h"
#include "eval/run/trial_world.h"

namespace honka::eval {

/// A short drive somewhere on the work path of a world, of which one window was cast.
struct DrawnWindow {
  Drive drive;                            ///< its key frames are the window's
  std::vector<std::vector<Sweep>> scans;  ///< one entry a key frame
};

/// Key frames before a window begins: how many is drawn below this. A machine that has just set off
/// stands, drives or works in the window's first frame.
inline constexpr std::uint64_t kKeyFramesBeforeWindow = 10;

/// Draws where on the work path a drive sets off, in which of both directions, and which of its key
/// frames is the first of the window; casts the sweeps of these `frames` key frames alone (all
/// sweeps of the short drive for an odometry that needs them), on one thread. Drive and odometry
/// have chances of their own in each draw. The digits depend on (scenario, world, draw) alone.
/// UserError where the work path is shorter than the drive. The window has fewer frames only where
/// a lidar odometry lost its way.
[[nodiscard]] DrawnWindow draw_window(const Scenario& scenario, const TrialWorld& world,
                                      std::int64_t frames, std::int64_t draw);

}  // namespace honka::eval
