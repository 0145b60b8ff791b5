#include "eval/run/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/types/user_error.h"
#include "eval/io/context.h"
#include "eval/io/recording.h"
#include "eval/run/drive.h"
#include "eval/run/odometry_drive.h"
#include "eval/run/progress.h"
#include "eval/run/trial_world.h"

namespace honka::eval {
namespace {

/// Distance in time of the truth's poses in the recording; between them it is smooth to 0.1 mm.
constexpr double kKnotPeriod_s = 0.01;

struct SweepRange {
  std::int64_t first = 0, end = 0;
};

SweepRange sweep_range(const ResolvedScenario& resolved, double period_s, double duration_s) {
  const SimulateSettings& settings = resolved.scenario.simulate;
  const auto total = static_cast<std::int64_t>(duration_s / period_s);
  const auto first = static_cast<std::int64_t>(std::ceil(settings.start_s / period_s));
  const auto end =
      static_cast<std::int64_t>(std::llround((settings.start_s + settings.duration_s) / period_s));
  if (first >= total) {
    throw UserError(fmt::format("simulate.start_s = {} lies beyond the drive's {:.0f} s; lower it",
                                settings.start_s, duration_s));
  }
  return {first, std::min(end, total)};
}

StemTruth stem_truth(const sim::Stand& stand) {
  StemTruth truth;
  truth.stems_in_world = true_stems(stand);
  for (const sim::Tree& tree : stand.trees) truth.ids.push_back(tree.id);
  return truth;
}

/// T_vehicle_lidar; the vehicle frame lies on the ground below the joint.
Pose3 mounting(const sim::VehicleSettings& vehicle) {
  return pose_from_rpy({vehicle.joint_to_lidar_m, 0.0, vehicle.sensor_height_m},
                       deg_to_rad(vehicle.mount_roll_deg), deg_to_rad(vehicle.mount_pitch_deg),
                       0.0);
}

void append(RecordingWriter& writer, const sim::Trajectory& trajectory, double period_s,
            const sim::TruthfulSweep& sweep) {
  const auto knots = static_cast<int>(std::lround(period_s / kKnotPeriod_s));
  std::vector<double> times_s;
  std::vector<Pose3> poses;
  for (int k = 0; k <= knots; ++k) {
    times_s.push_back(period_s * (static_cast<double>(sweep.sweep.index) +
                                  static_cast<double>(k) / static_cast<double>(knots)));
    poses.push_back(trajectory.T_world_lidar(times_s.back()));
  }
  writer.append(sweep, poses, times_s);
}

}  // namespace

SimulateOutcome simulate(const ResolvedScenario& resolved, const std::filesystem::path& out,
                         int threads) {
  const Scenario& scenario = resolved.scenario;
  const TrialWorld world = make_trial_world(scenario, 0);
  const DriveOrder order = scenario.simulate.run == "prior_run" ? prior_drive(scenario, world)
                                                                : work_drive(scenario, world);
  const auto vehicle = make_vehicle(order, world.seed);
  const sim::Trajectory& trajectory = vehicle->trajectory();
  const double period_s = order.stand->lidar->model().sweep_period_s();
  const auto [first, end] = sweep_range(resolved, period_s, trajectory.duration_s());

  auto context = Context(threads, scenario.seed).entries();
  context["scenario_hash"] = resolved.hash;
  RecordingWriter writer(out, order.stand->lidar->model(), mounting(*order.vehicle),
                         stem_truth(order.stand->stand), context);
  Progress progress("recording", "sweeps", end - first);
  SimulateOutcome outcome;
  std::vector<std::int64_t> wanted(static_cast<std::size_t>(end - first));
  std::iota(wanted.begin(), wanted.end(), first);
  const auto record = [&](sim::TruthfulSweep&& sweep) {
    append(writer, trajectory, period_s, sweep);
    ++outcome.sweeps;
    outcome.shots += static_cast<std::int64_t>(sweep.truth.size());
    outcome.returns += std::count_if(sweep.truth.begin(), sweep.truth.end(), [](const auto& t) {
      return t.label.part != sim::Part::kNone;
    });
  };
  stream_sweeps(*vehicle, *order.stand->lidar, wanted, threads, progress, record);
  writer.commit();
  return outcome;
}

}  // namespace honka::eval
