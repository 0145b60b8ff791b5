#include "eval/run/drawn_window.h"

#include <fmt/format.h>

#include <algorithm>

#include "algo/types/random.h"
#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

/// Room at the end of a short drive: the machine slows down, and the odometry's noise makes some
/// key frames later than others.
constexpr double kSlackAtEnd_m = 2.0;

/// Way that so many key frames take at most: one becomes due at most a sweep too late.
double way_of(std::size_t key_frames, const Scenario& scenario, double sweep_period_s) {
  const double apart_m =
      scenario.frame.distance_m + scenario.harvester.drive_speed_m_s * sweep_period_s;
  const double jitter_m = 2.0 * scenario.odometry.jitter_m;
  return static_cast<double>(key_frames) * (apart_m + jitter_m) + kSlackAtEnd_m;
}

/// A piece of a path, with a point every half metre or so.
sim::Polyline piece_of(const sim::Polyline& path, double from_m, double way_m, bool reversed) {
  sim::Polyline piece;
  const auto steps = static_cast<int>(std::max(1.0, std::round(2.0 * way_m)));
  for (int i = 0; i <= steps; ++i) {
    piece.push_back(sim::point_at(path, from_m + way_m * i / steps));
  }
  if (reversed) std::reverse(piece.begin(), piece.end());
  return piece;
}

}  // namespace

DrawnWindow draw_window(const Scenario& scenario, const TrialWorld& world, std::int64_t frames,
                        std::int64_t draw) {
  const std::uint64_t seed =
      derive_seed(world.seed, "drawn_window", {static_cast<std::uint64_t>(draw)});
  const double path_m = sim::length_m(world.work_path);
  const auto count = static_cast<std::size_t>(frames);
  const double way_m =
      way_of(kKeyFramesBeforeWindow + count, scenario, world.lidar->model().sweep_period_s());
  if (way_m > path_m) {
    throw UserError(
        fmt::format("protocol.path_length_m = {}: windows of {} key frames need a path "
                    "of {:.0f} m; make it longer",
                    scenario.protocol.path_length_m, frames, way_m));
  }
  // Where, which way, and when
  RandomStream stream(seed, "window_place");
  const double from_m = stream.uniform() * (path_m - way_m);
  const bool reversed = stream.uniform() < 0.5;
  const auto first = static_cast<std::size_t>(stream.below(kKeyFramesBeforeWindow));
  // The drive
  const double driven_m = way_of(first + count, scenario, world.lidar->model().sweep_period_s());
  const sim::Polyline path = piece_of(world.work_path, from_m, driven_m, reversed);
  const DriveOrder order{"window", &path, &scenario.harvester, &world};
  DrawnWindow window;
  window.drive = drive_and_scan(order, scenario, seed, "", 1,
                                [&](const KeyFrame&, std::vector<sim::TruthfulSweep>&& sweeps) {
                                  window.scans.push_back(scans_of(std::move(sweeps)));
                                },
                                {first, count});
  return window;
}

}  // namespace honka::eval
