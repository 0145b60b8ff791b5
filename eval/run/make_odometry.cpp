#include "eval/run/make_odometry.h"

#include "eval/run/truth_noise_odometry.h"

namespace honka::eval {

std::unique_ptr<Odometry> make_odometry(const OdometrySettings& settings,
                                        const sim::Trajectory& truth, const LidarModel& model,
                                        std::int64_t sweeps, std::uint64_t seed) {
  if (settings.source == "truth+noise") {
    return std::make_unique<TruthNoiseOdometry>(truth, model.sweep_period_s(), sweeps, settings,
                                                seed);
  }
  return create_odometry(settings.source, model, settings.lidar);
}

}  // namespace honka::eval
