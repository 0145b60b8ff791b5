#include "tests/algo/slam/methods_world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algo/slam/chain.h"
#include "algo/types/random.h"

namespace honka::test {
namespace {

constexpr std::uint64_t kWorldSeed = 41;

std::vector<Eigen::Vector3d> jittered_lattice(double length_m) {
  constexpr double kSpacing_m = 3.3, kRim_m = 30.0;
  std::vector<Eigen::Vector3d> stems;
  std::uint64_t number = 0;
  for (double x = -kRim_m; x < length_m + kRim_m; x += kSpacing_m) {
    for (double y = -kRim_m; y < kRim_m; y += kSpacing_m) {
      RandomStream random(kWorldSeed, "lattice", {number++});
      const double at_x = x + random.uniform(-1.2, 1.2), at_y = y + random.uniform(-1.2, 1.2);
      stems.emplace_back(at_x, at_y, std::sin(0.1 * at_x) + 0.05 * at_y);
    }
  }
  return stems;
}

Pose3 pose_on_track(double s_m) {
  const double yaw_rad = 0.3 * std::sin(0.15 * s_m);
  return pose_from_rpy({s_m, 2.0 * std::sin(0.15 * s_m), 0.05 * s_m}, 0.02 * std::sin(s_m),
                       0.03 * std::cos(0.7 * s_m), yaw_rad);
}

SparseFrame seen_from(const Pose3& T_first_frame, const std::vector<Eigen::Vector3d>& stems_m,
                      std::size_t frame, double noise_m) {
  constexpr double kRange_m = 25.0;
  SparseFrame result{static_cast<std::int64_t>(frame), {}};
  RandomStream random(kWorldSeed, "noise", {frame});
  for (const Eigen::Vector3d& stem_m : stems_m) {
    Eigen::Vector3d point = T_first_frame.inverse() * stem_m;
    if (point.head<2>().norm() > kRange_m) continue;
    point += noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    result.points_m.push_back(point);
  }
  return result;
}

}  // namespace

MethodsWorld methods_world(std::size_t frames, double noise_m) {
  constexpr double kStep_m = 0.5;
  MethodsWorld world;
  const Pose3 T_first_world = pose_on_track(0.0).inverse();
  for (const Eigen::Vector3d& stem_m : jittered_lattice(kStep_m * static_cast<double>(frames))) {
    world.stems_in_first_m.push_back(T_first_world * stem_m);
  }
  for (std::size_t l = 0; l < frames; ++l) {
    world.T_first_frame.push_back(T_first_world * pose_on_track(kStep_m * static_cast<double>(l)));
    world.frames.push_back(
        seen_from(world.T_first_frame.back(), world.stems_in_first_m, l, noise_m));
  }
  if (frames > 0) world.T_first_frame.front() = Pose3::Identity();
  return world;
}

FramePoses bent_chain(const FramePoses& T_first_frame, double turn_rad, double shift_m) {
  const Pose3 off = pose_from_rpy({shift_m, -0.5 * shift_m, 0.2 * shift_m}, 0.1 * turn_rad,
                                  -0.1 * turn_rad, turn_rad);
  FramePoses bent = {T_first_frame.front()};
  for (std::size_t l = 0; l + 1 < T_first_frame.size(); ++l) {
    bent.push_back(bent.back() * between(T_first_frame, l, l + 1) * off);
  }
  return bent;
}

std::vector<PairMatch> true_matches(const FramePoses& T_first_frame, std::size_t gap) {
  std::vector<PairMatch> matches;
  for (std::size_t j = 0; j + gap < T_first_frame.size(); j += std::max<std::size_t>(1, gap / 2)) {
    matches.push_back({j, j + gap, between(T_first_frame, j, j + gap), 0.1, 0.6});
  }
  return matches;
}

double aligned_error_m(const FramePoses& estimate, const FramePoses& truth) {
  const auto n = static_cast<Eigen::Index>(truth.size());
  Eigen::Matrix3Xd from(3, n), to(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    from.col(i) = estimate[static_cast<std::size_t>(i)].translation();
    to.col(i) = truth[static_cast<std::size_t>(i)].translation();
  }
  const Eigen::Matrix4d T = Eigen::umeyama(from, to, false);
  const Eigen::Matrix3Xd laid =
      (T.topLeftCorner<3, 3>() * from).colwise() + T.topRightCorner<3, 1>();
  return std::sqrt((laid - to).squaredNorm() / static_cast<double>(n));
}

double largest_difference(const FramePoses& a, const FramePoses& b) {
  double largest = a.size() == b.size() ? 0.0 : 1e300;
  for (std::size_t l = 0; l < std::min(a.size(), b.size()); ++l) {
    largest = std::max(largest, (a[l].matrix() - b[l].matrix()).cwiseAbs().maxCoeff());
  }
  return largest;
}

bool all_poses_finite(const FramePoses& poses) {
  return std::all_of(poses.begin(), poses.end(),
                     [](const Pose3& pose) { return pose.matrix().allFinite(); });
}

}  // namespace honka::test
