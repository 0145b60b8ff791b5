#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/lidar/build_statistics.h"
#include "sim/lidar/echoes.h"
#include "sim/lidar/lidar_settings.h"
#include "sim/world/recording.h"
#include "sim/world/trajectory.h"

namespace honka::sim {

class EmbreeScene;
class Shooter;

/// A spinning lidar in a world: casts sweeps, each ray at its own time and from its own pose.
class LidarSimulator {
 public:
  /// Builds the hierarchy over `world`. `seed` decides the unit's biases and all noise. Throws
  /// UserError for settings that name nothing.
  LidarSimulator(const World& world, const LidarSettings& settings, std::uint64_t seed);
  ~LidarSimulator();

  [[nodiscard]] const LidarModel& model() const { return model_; }

  /// The revolution that starts at `sweep_index` × sweep period (index at least 0), at the rear, so
  /// that the field of view is one piece. Lists the shots inside the field of view in firing order;
  /// misses stay, with range 0. Firings follow one clock that runs on from sweep to sweep, so the
  /// first firing comes up to one firing period after the start. Digits depend on (seed, index,
  /// firing, laser) alone. Thread-safe.
  [[nodiscard]] TruthfulSweep cast(const Trajectory& trajectory, std::int64_t sweep_index,
                                   std::span<const Cone> occluders_in_lidar = {}) const;

  /// Time, memory and size of the hierarchy.
  [[nodiscard]] const BuildStatistics& statistics() const;
  [[nodiscard]] const EmbreeScene& scene() const { return *scene_; }
  /// Bias of each laser of this unit. Metres.
  [[nodiscard]] const std::vector<double>& biases_m() const { return biases_m_; }

 private:
  friend class Shooter;

  /// One laser's part of a firing, ready to turn.
  struct Beam {
    double cos_elevation, sin_elevation;
    double cos_turn, sin_turn;  ///< of the head between the firing's start and this shot
    double turn_rad;
    double origin_z_m;
    double offset_s;
  };

  LidarSettings settings_;
  LidarModel model_;
  ReturnMode mode_;
  std::vector<SubRay> footprint_;
  std::vector<Beam> beams_;
  std::vector<double> biases_m_;
  std::array<double, kPartCount> reflectivity_percent_;
  std::uint64_t noise_key_;
  std::unique_ptr<EmbreeScene> scene_;
};

}  // namespace honka::sim
