#pragma once

#include "algo/slam/view_cone.h"
#include "algo/types/random.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// A drive along a gentle bow through a stand of stems 1.6 m apart or more: a key frame every 0.5 m
/// and 0.5 s, its stems without noise, the edge's poses true.
inline SlamDrive straight_drive(int frames) {
  SlamDrive drive;
  RandomStream stream(4, "test_link_drive");
  for (double x = -20.0; x < 0.5 * frames + 20.0; x += 4.0) {
    for (double y = -25.0; y < 25.0; y += 4.0) {
      drive.true_stems_in_first_m.emplace_back(x + stream.uniform(-1.2, 1.2),
                                               y + stream.uniform(-1.2, 1.2), 0.5);
    }
  }
  const ViewCone cone;
  for (int i = 0; i < frames; ++i) {
    const double way_m = 0.5 * i;
    drive.true_T_first_frame.push_back(
        pose_from_rpy({way_m, 0.002 * way_m * way_m, 0.0}, 0.0, 0.0, 0.004 * way_m));
    drive.frames.push_back({i, {}});
    for (const Eigen::Vector3d& stem : drive.true_stems_in_first_m) {
      const Eigen::Vector3d point = drive.true_T_first_frame.back().inverse() * stem;
      if (cone.holds(point.head<2>())) drive.frames.back().points_m.push_back(point);
    }
    drive.times_s.push_back(way_m);
    drive.travelled_m.push_back(way_m);
  }
  drive.edge_T_first_frame = drive.true_T_first_frame;
  drive.duration_s = 0.5 * frames;
  drive.sweeps = 5 * frames;
  return drive;
}

}  // namespace honka::eval
