#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sim/lidar/embree_scene.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/lidar/occluders.h"
#include "sim/lidar/shot_noise.h"
#include "sim/lidar/sweep_poses.h"

namespace honka::sim {

/// Casts one sweep, firing by firing.
class Shooter {
 public:
  Shooter(const LidarSimulator& lidar, const Trajectory& trajectory, std::int64_t sweep_index,
          std::span<const Cone> occluders_in_lidar);

  /// All lasers once; `firing` counts within the sweep, `offset_s` after the sweep's start.
  void fire(std::uint32_t firing, double offset_s);
  [[nodiscard]] TruthfulSweep take() { return std::move(result_); }

 private:
  using Beam = LidarSimulator::Beam;

  [[nodiscard]] bool in_view(double azimuth_rad) const;
  /// Queues the rays of one shot.
  void aim(const Beam& beam, double offset_s);
  /// The echoes of the shot whose rays start at `first` in the queue; how many.
  int receive(std::size_t first);
  void finish(std::uint32_t firing, std::uint32_t laser, double offset_s, int echoes);
  [[nodiscard]] Hit hit_of(std::size_t query) const;
  [[nodiscard]] bool detected(const Echo& echo, std::uint32_t bits) const;
  void report(const Echo* echo, std::uint32_t laser, double offset_s, std::uint32_t noise_bits,
              std::uint8_t number);

  const LidarSimulator& lidar_;
  const EmbreeScene& scene_;
  SweepPoses poses_;
  Occluders occluders_;
  TruthfulSweep result_;
  double ticks_per_m_;
  double half_view_rad_;
  double head_cos_ = 1.0, head_sin_ = 0.0;  ///< of the azimuth at the firing's start
  std::vector<RTCRayHit> queries_;          ///< of one firing, sub-rays of a shot together
  std::size_t aimed_ = 0;                   ///< queries in use
  std::vector<Hit> machine_;                ///< beside the queries, while occluders are aimed at
  std::array<SubHit, kMostSubRays> hits_;
  Echoes echoes_;
};

}  // namespace honka::sim
