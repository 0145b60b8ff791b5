#include "eval/run/odometry_drive.h"

#include <atomic>
#include <exception>
#include <numeric>

namespace honka::eval {

std::int64_t sweeps_of(const sim::Vehicle& vehicle, const LidarModel& model) {
  return static_cast<std::int64_t>(vehicle.trajectory().duration_s() / model.sweep_period_s());
}

sim::TruthfulSweep cast_sweep(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar,
                              std::int64_t index) {
  const double middle_s = lidar.model().sweep_period_s() * (static_cast<double>(index) + 0.5);
  return lidar.cast(vehicle.trajectory(), index, vehicle.occluders_in_lidar(middle_s));
}

Sweep empty_sweep(const LidarModel& model, std::int64_t index) {
  Sweep sweep;
  sweep.index = index;
  sweep.start_time_s = model.sweep_period_s() * static_cast<double>(index);
  return sweep;
}

void stream_sweeps(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar,
                   const std::vector<std::int64_t>& indices, int threads, Progress& progress,
                   const TakeSweep& take) {
  std::exception_ptr failure;
  std::atomic<bool> failed = false;  // read by threads that cast while another one takes
#pragma omp parallel for ordered schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < indices.size(); ++i) {
    sim::TruthfulSweep sweep;
    if (!failed) sweep = cast_sweep(vehicle, lidar, indices[i]);
#pragma omp ordered
    {
      try {
        if (!failed) {
          take(std::move(sweep));
          progress.advance();
        }
      } catch (...) {
        failure = std::current_exception();
        failed = true;
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

void stream_sweeps(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar, int threads,
                   Progress& progress, const TakeSweep& take) {
  std::vector<std::int64_t> indices(static_cast<std::size_t>(sweeps_of(vehicle, lidar.model())));
  std::iota(indices.begin(), indices.end(), 0);
  stream_sweeps(vehicle, lidar, indices, threads, progress, take);
}

OdometryTrack drive_with_odometry(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar,
                                  Odometry& odometry, int threads, Progress& progress,
                                  const std::function<void(DriveSweep&&)>& sink) {
  OdometryTrack track;
  const auto take = [&](sim::TruthfulSweep&& sweep) {
    const OdometryEstimate estimate = odometry.process(sweep.sweep);
    track.add(estimate);
    if (sink) sink({std::move(sweep), estimate});
  };
  if (odometry.needs_returns()) {
    stream_sweeps(vehicle, lidar, threads, progress, take);
    return track;
  }
  for (std::int64_t k = 0; k < sweeps_of(vehicle, lidar.model()); ++k) {
    take({empty_sweep(lidar.model(), k), {}});
    progress.advance();
  }
  return track;
}

}  // namespace honka::eval
