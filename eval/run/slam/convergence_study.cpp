#include "eval/run/slam/convergence_study.h"

#include <cmath>

#include "algo/slam/chain.h"
#include "algo/slam/convergence.h"
#include "algo/slam/view_cone.h"
#include "algo/types/random.h"
#include "eval/run/parallel.h"

namespace honka::eval {
namespace {

constexpr double kLeastOverlap = 0.4;  // 1 − γ of the paper
constexpr double kLeastApartM = 1.0;
constexpr std::size_t kLeastStems = 20;
constexpr std::uint64_t kFarthestFrames = 400;
constexpr std::uint64_t kTriesPerPair = 1000;
constexpr int kStartDirections = 4;
constexpr double kSuccessM = 0.5, kSuccessDeg = 2.0;

bool is_registrable(const SparseFrame& frame) {
  return frame.points_m.size() >= kLeastStems &&
         registrable(frame.points_m) == RegistrationStatus::kRegistered;
}

/// The mismatch of one start: the d-th of four directions from a random one.
Pose3 mismatch_of(const StartError& start, std::uint64_t seed, std::uint64_t pair, int direction) {
  RandomStream random(seed, "start_direction", {pair});
  const double azimuth_rad = random.uniform(-kPi, kPi) + 0.5 * kPi * direction;
  const double tilt_azimuth_rad = random.uniform(-kPi, kPi) + 0.5 * kPi * direction;
  const double turn_rad = deg_to_rad(start.turn_deg) * (direction % 2 == 0 ? 1.0 : -1.0);
  const Eigen::Vector3d tilt_axis(std::cos(tilt_azimuth_rad), std::sin(tilt_azimuth_rad), 0.0);
  Pose3 mismatch = Pose3::Identity();
  mismatch.translation() =
      start.shift_m * Eigen::Vector3d(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0);
  mismatch.linear() = (Eigen::AngleAxisd(deg_to_rad(start.tilt_deg), tilt_axis) *
                       Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()))
                          .toRotationMatrix();
  return mismatch;
}

bool is_right(const Pose3& found, const Pose3& truth) {
  const Pose3 miss = truth.inverse() * found;
  return miss.translation().norm() <= kSuccessM &&
         Eigen::AngleAxisd(miss.linear()).angle() <= deg_to_rad(kSuccessDeg);
}

ConvergencePoint study_start(const SlamDrive& drive, const std::vector<ConvergencePair>& pairs,
                             const StartError& start, std::uint64_t seed) {
  ConvergencePoint point{start};
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ConvergencePair& pair = pairs[k];
    for (int direction = 0; direction < kStartDirections; ++direction) {
      const Registration icp = trimmed_icp(
          pair.stems, drive.frames[pair.target].points_m, drive.frames[pair.source].points_m,
          pair.T_target_source * mismatch_of(start, seed, k, direction), {});
      point.error_m += icp.rmse_m;
      point.success += is_right(icp.T_target_source, pair.T_target_source) ? 1.0 : 0.0;
      ++point.starts;
    }
  }
  if (point.starts > 0) {
    point.error_m /= static_cast<double>(point.starts);
    point.success /= static_cast<double>(point.starts);
  }
  return point;
}

}  // namespace

std::vector<ConvergencePair> draw_convergence_pairs(const SlamDrive& drive, std::size_t count,
                                                    std::uint64_t seed) {
  std::vector<ConvergencePair> pairs;
  const auto n = static_cast<std::uint64_t>(drive.frames.size());
  if (n < 2) return pairs;
  const ViewOverlap overlap{ViewCone{}};
  for (std::uint64_t attempt = 0; pairs.size() < count && attempt < kTriesPerPair * count;
       ++attempt) {
    RandomStream random(seed, "convergence_pair", {attempt});
    const auto j = static_cast<std::size_t>(random.below(n));
    const auto i = j + 1 + static_cast<std::size_t>(random.below(kFarthestFrames));
    if (i >= n || !is_registrable(drive.frames[i]) || !is_registrable(drive.frames[j])) continue;
    const Pose3 T_j_i = between(drive.true_T_first_frame, j, i);
    const double lambda = overlap(T_j_i);
    if (lambda < kLeastOverlap || T_j_i.translation().norm() < kLeastApartM) continue;
    pairs.push_back({j, i, T_j_i, lambda, NearestStems(drive.frames[j].points_m)});
  }
  return pairs;
}

std::vector<ConvergencePoint> study_convergence(const SlamDrive& drive,
                                                const std::vector<ConvergencePair>& pairs,
                                                const std::vector<StartError>& starts,
                                                std::uint64_t seed, int threads) {
  std::vector<ConvergencePoint> points(starts.size());
  for_each_index(starts.size(), threads,
                 [&](std::size_t k) { points[k] = study_start(drive, pairs, starts[k], seed); });
  return points;
}

std::vector<StartError> starts_on_ellipse(double shift_m, double turn_deg) {
  std::vector<StartError> starts;
  for (int k = 0; k <= 12; ++k) {
    const double angle_rad = 0.5 * kPi * k / 12.0;
    starts.push_back({shift_m * std::cos(angle_rad), turn_deg * std::sin(angle_rad), 0.0});
  }
  return starts;
}

double mean_frame_l0_m(const SlamDrive& drive) {
  double sum_m = 0.0;
  for (const SparseFrame& frame : drive.frames) {
    sum_m += mean_neighbour_distance_m(frame.points_m);
  }
  return drive.frames.empty() ? 0.0 : sum_m / static_cast<double>(drive.frames.size());
}

}  // namespace honka::eval
