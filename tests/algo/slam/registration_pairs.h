#pragma once

#include <algorithm>
#include <cmath>

#include "tests/algo/slam/core_world.h"
#include "tests/support/slam_case.h"

namespace honka::test {

/// Two clouds to be registered, with the answer and a guess that is off by up to 30° and 5 m.
struct RegistrationPair {
  StemPoints target_m, source_m;
  Pose3 T_target_source = Pose3::Identity();
  Pose3 guess = Pose3::Identity();
  double partners = 0.0;  ///< part of the source's points whose tree the target has too
};

inline double planar_distance_m(const Pose3& a, const Pose3& b) {
  return (a.translation() - b.translation()).head<2>().norm();
}

inline double yaw_difference_deg(const Pose3& a, const Pose3& b) {
  return rad_to_deg(std::abs(wrap_to_pi(yaw_of(a) - yaw_of(b))));
}

inline bool is_right(const Pose3& estimate, const Pose3& truth) {
  return planar_distance_m(estimate, truth) < 0.5 && yaw_difference_deg(estimate, truth) < 2.5;
}

/// The true pose, turned about the sensor and moved.
inline Pose3 disturbed(const Pose3& truth, double yaw_deg, double x_m, double y_m) {
  Pose3 guess = truth;
  guess.linear() =
      Eigen::AngleAxisd(deg_to_rad(yaw_deg), Eigen::Vector3d::UnitZ()) * truth.linear();
  guess.translation() += Eigen::Vector3d(x_m, y_m, 0.0);
  return guess;
}

/// Two views of a random stand of 0.03 stems/m², 6 m and 20° apart.
inline RegistrationPair pair_of_views(std::uint64_t id, double noise_m) {
  const StemPoints stems = random_stems(250, 90.0, id);
  const Pose3 T_world_target = Pose3::Identity();
  const Pose3 T_world_source = pose_from_rpy({5.0, 3.0, 0.1}, 0.01, -0.02, deg_to_rad(20.0));
  RegistrationPair pair;
  pair.target_m = seen_from(stems, T_world_target, noise_m, 2 * id);
  pair.source_m = seen_from(stems, T_world_source, noise_m, 2 * id + 1);
  pair.T_target_source = T_world_target.inverse() * T_world_source;
  RandomStream random(11, "pair_guess", {id});
  pair.guess = disturbed(pair.T_target_source, random.uniform(-30.0, 30.0),
                         random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
  return pair;
}

/// Pairs of case 0 with frame gaps spread over 1 … 1000 and at least `least_partners` of the
/// source points with a true partner. Tree numbers choose the pairs and go no further.
inline std::vector<RegistrationPair> pairs_of_case(const std::filesystem::path& folder,
                                                   std::size_t count, double least_partners) {
  std::vector<StemPoints> points;
  std::vector<std::vector<int>> trees;
  for (const auto& row : read_number_rows(folder / "case0_points.csv.gz")) {
    const auto frame = static_cast<std::size_t>(row.at(0));
    points.resize(std::max(points.size(), frame + 1));
    trees.resize(points.size());
    points[frame].emplace_back(row.at(1), row.at(2), row.at(3));
    trees[frame].push_back(static_cast<int>(row.at(4)));
  }
  const auto poses = read_pose_rows(folder / "case0_true_pose.csv");
  std::vector<RegistrationPair> pairs;
  for (std::uint64_t k = 0; pairs.size() < count; ++k) {
    RandomStream random(11, "case_pair", {k});
    const auto gap = static_cast<std::size_t>(std::exp(random.uniform(0.0, std::log(1000.0))));
    const auto i = static_cast<std::size_t>(random.below(points.size()));
    if (i < gap) continue;
    const std::size_t j = i - gap;
    const auto in_both = std::count_if(trees[i].begin(), trees[i].end(), [&](int tree) {
      return tree >= 0 && std::count(trees[j].begin(), trees[j].end(), tree) > 0;
    });
    RegistrationPair pair{points[j], points[i], poses[j].inverse() * poses[i]};
    pair.partners = static_cast<double>(in_both) / static_cast<double>(points[i].size());
    if (pair.partners < least_partners) continue;
    pair.guess = disturbed(pair.T_target_source, random.uniform(-30.0, 30.0),
                           random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace honka::test
