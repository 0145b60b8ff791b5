#include "algo/slam/chain.h"

#include <algorithm>

#include "algo/types/check.h"

namespace honka {
namespace {

TrimmedIcpSettings icp_of(const ChainSettings& settings) {
  TrimmedIcpSettings icp;
  icp.inlier_ratio = settings.inlier_ratio;
  icp.max_iterations = settings.max_iterations;
  icp.tolerance_m = settings.tolerance_m;
  icp.tolerance_deg = settings.tolerance_deg;
  return icp;
}

/// Composed thousands of times a rotation drifts off the rotations: the nearest one again.
Pose3 with_clean_rotation(const Pose3& pose) {
  Pose3 clean = pose;
  clean.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return clean;
}

}  // namespace

void describe(SettingsVisitor& v, ChainSettings& s) {
  v.field({"inlier_ratio", "", "part of the points that the ICP between neighbours is fitted to",
           "choice: Nevalainen2021 prints none; 0.95 gives its initial blur"},
          s.inlier_ratio, Range{0.01, 1.0});
  v.field({"max_iterations", "", "ICP steps at most", "Matlab R2020b: pcregistericp, 30"},
          s.max_iterations, Range{1.0, 1e4});
  v.field({"tolerance_m", "m", "mean movement of the last three ICP steps that ends it",
           "Matlab: pcregistericp, 0.01"},
          s.tolerance_m, Range{0.0, 10.0});
  v.field({"tolerance_deg", "deg", "mean turn of the last three ICP steps that ends it",
           "Matlab: pcregistericp, 0.5"},
          s.tolerance_deg, Range{0.0, 180.0});
  v.field({"guess", "", "where the ICP between neighbours starts: no motion, or the last step's",
           "choice: pcregistericp starts without one"},
          s.guess, {"identity", "constant_velocity"});
  v.field({"failed_step", "", "motion of a step that cannot be registered", "choice"},
          s.failed_step, {"identity", "constant_velocity"});
}

int Chain::failed_steps() const {
  return static_cast<int>(std::count_if(steps.begin(), steps.end(),
                                        [](const Registration& step) { return !step.usable(); }));
}

Chain make_chain(std::span<const SparseFrame> frames, const ChainSettings& settings) {
  Chain chain;
  if (frames.empty()) return chain;
  const TrimmedIcpSettings icp = icp_of(settings);
  chain.T_first_frame.push_back(Pose3::Identity());
  Pose3 T_before_last = Pose3::Identity();  // the last step that was taken
  for (std::size_t l = 1; l < frames.size(); ++l) {
    const Pose3 guess = settings.guess == "constant_velocity" ? T_before_last : Pose3::Identity();
    Registration step = trimmed_icp(frames[l - 1].points_m, frames[l].points_m, guess, icp);
    if (!step.usable()) {
      step.T_target_source =
          settings.failed_step == "constant_velocity" ? T_before_last : Pose3::Identity();
    }
    // Nevalainen2021 Eq. (16)
    T_before_last = step.T_target_source;
    chain.T_first_frame.push_back(
        with_clean_rotation(chain.T_first_frame.back() * step.T_target_source));
    chain.steps.push_back(step);
  }
  return chain;
}

Pose3 between(const FramePoses& T_first_frame, std::size_t j, std::size_t i) {
  // Nevalainen2021 Eq. (17)
  return T_first_frame.at(j).inverse() * T_first_frame.at(i);
}

std::vector<Eigen::Vector3d> path_of(const FramePoses& T_first_frame) {
  // Nevalainen2021 Eq. (18)
  std::vector<Eigen::Vector3d> path;
  path.reserve(T_first_frame.size());
  for (const Pose3& pose : T_first_frame) path.emplace_back(pose.translation());
  return path;
}

std::vector<Eigen::Vector3d> map_points(std::span<const SparseFrame> frames,
                                        const FramePoses& T_first_frame) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "a map needs a pose a frame");
  std::vector<Eigen::Vector3d> points;
  for (std::size_t l = 0; l < frames.size(); ++l) {
    for (const Eigen::Vector3d& p : frames[l].points_m) points.emplace_back(T_first_frame[l] * p);
  }
  return points;
}

}  // namespace honka
