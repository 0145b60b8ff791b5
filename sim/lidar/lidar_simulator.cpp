#include "sim/lidar/lidar_simulator.h"

#include <cmath>

#include "algo/types/check.h"
#include "algo/types/random.h"
#include "sim/lidar/embree_scene.h"
#include "sim/lidar/shooter.h"

namespace honka::sim {

LidarSimulator::LidarSimulator(const World& world, const LidarSettings& settings,
                               std::uint64_t seed)
    : settings_(settings),
      model_(make_lidar_model(settings)),
      mode_(return_mode(settings.return_mode)),
      footprint_(footprint(static_cast<int>(settings.sub_rays), settings.divergence_horizontal_mrad,
                           settings.divergence_vertical_mrad)),
      reflectivity_percent_(world.reflectivity_percent),
      noise_key_(derive_seed(seed, "lidar_shot")),
      scene_(std::make_unique<EmbreeScene>(world)) {
  for (std::size_t id = 0; id < model_.lasers.size(); ++id) {
    const Laser& laser = model_.lasers[id];
    const double turn = 2.0 * kPi * model_.rotation_rate_hz * laser.firing_offset_s;
    beams_.push_back({std::cos(laser.elevation_rad), std::sin(laser.elevation_rad), std::cos(turn),
                      std::sin(turn), turn, laser.vertical_offset_m, laser.firing_offset_s});
    RandomStream stream(seed, "lidar_bias", {id});
    biases_m_.push_back(stream.uniform(-settings.range_bias_m, settings.range_bias_m));
  }
}

LidarSimulator::~LidarSimulator() = default;

const BuildStatistics& LidarSimulator::statistics() const { return scene_->statistics(); }

TruthfulSweep LidarSimulator::cast(const Trajectory& trajectory, std::int64_t sweep_index,
                                   std::span<const Cone> occluders_in_lidar) const {
  HONKA_CHECK(sweep_index >= 0, "sweeps count from 0");
  Shooter shooter(*this, trajectory, sweep_index, occluders_in_lidar);
  // The firing clock runs on from sweep to sweep: a revolution holds 1,808.4 firings at 10 Hz.
  const double period = model_.sweep_period_s();
  const double start = static_cast<double>(sweep_index) * period;
  constexpr double kClockSlack = 1e-6;  // firings, against the rounding of the division
  const auto first =
      static_cast<std::int64_t>(std::ceil(start / model_.firing_period_s - kClockSlack));
  const auto end =
      static_cast<std::int64_t>(std::ceil((start + period) / model_.firing_period_s - kClockSlack));
  for (std::int64_t firing = first; firing < end; ++firing) {
    const double offset = static_cast<double>(firing) * model_.firing_period_s - start;
    shooter.fire(static_cast<std::uint32_t>(firing - first), std::max(0.0, offset));
  }
  return shooter.take();
}

}  // namespace honka::sim
