#include "algo/slam/registration/trimmed_icp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algo/geometry/fit_pose.h"
#include "algo/types/check.h"

namespace honka {
namespace {

constexpr double kLineWidthM = 1e-3;  // points within this of a line fix no rotation about it

using IcpPoints = std::span<const Eigen::Vector3d>;

/// The pairs that one step is fitted to.
struct TrimmedPairs {
  std::vector<NearestStem> partner;      ///< of each source point, at the pose last asked for
  std::vector<std::int32_t> kept;        ///< source points, in input order
  std::vector<std::int32_t> kept_stems;  ///< their partners
  std::vector<std::int32_t> order;       ///< source points, the nearest pairs in front
};

/// Partners of all source points at the pose, and the `count` nearest pairs of them. False where
/// both are what they were.
bool pair_nearest(const NearestStems& target, IcpPoints target_m, IcpPoints source_m,
                  const Pose3& pose, std::size_t count, TrimmedPairs& pairs) {
  const bool first = pairs.partner.empty();
  if (first) pairs.partner.resize(source_m.size());
  pairs.order.resize(source_m.size());
  for (std::size_t k = 0; k < source_m.size(); ++k) {
    const Eigen::Vector3d place = pose * source_m[k];
    NearestStem& partner = pairs.partner[k];
    // The partner of the step before is near already.
    if (!first) {
      const Eigen::Vector3d& last = target_m[static_cast<std::size_t>(partner.index)];
      partner.squared_m2 = (last - place).squaredNorm();
    }
    partner = first ? target.nearest(place) : target.nearest(place, partner);
    pairs.order[k] = static_cast<std::int32_t>(k);
  }
  const auto nearer = [&](std::int32_t a, std::int32_t b) {
    const double left = pairs.partner[static_cast<std::size_t>(a)].squared_m2;
    const double right = pairs.partner[static_cast<std::size_t>(b)].squared_m2;
    return left != right ? left < right : a < b;
  };
  const auto end = pairs.order.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(pairs.order.begin(), end - 1, pairs.order.end(), nearer);
  std::sort(pairs.order.begin(), end);

  bool changed = first;
  pairs.kept.resize(count, -1);
  pairs.kept_stems.resize(count, -1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t point = pairs.order[k];
    const std::int32_t stem = pairs.partner[static_cast<std::size_t>(point)].index;
    changed |= pairs.kept[k] != point || pairs.kept_stems[k] != stem;
    pairs.kept[k] = point;
    pairs.kept_stems[k] = stem;
  }
  return changed;
}

Pose3 fit_pairs(IcpPoints target_m, IcpPoints source_m, const TrimmedPairs& pairs,
                const Eigen::Matrix3d& rotation_if_free) {
  std::vector<Eigen::Vector3d> target(pairs.kept.size()), source(pairs.kept.size());
  for (std::size_t k = 0; k < pairs.kept.size(); ++k) {
    target[k] = target_m[static_cast<std::size_t>(pairs.kept_stems[k])];
    source[k] = source_m[static_cast<std::size_t>(pairs.kept[k])];
  }
  return fit_pose(target, source, rotation_if_free);
}

/// How far a step moved and turned the source.
struct IcpStep {
  double moved_m = 0.0, turned_rad = 0.0;
};

IcpStep step_between(const Pose3& before, const Pose3& after) {
  const Eigen::Matrix3d turn = before.linear().transpose() * after.linear();
  const Eigen::Vector3d twice_sine(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                                   turn(1, 0) - turn(0, 1));
  return {(after * before.inverse()).translation().norm(),
          std::atan2(0.5 * twice_sine.norm(), 0.5 * (turn.trace() - 1.0))};
}

/// Whether the last three steps (fewer at the beginning) were within the tolerances on average.
bool at_rest(const std::array<IcpStep, 3>& last, std::int64_t steps,
             const TrimmedIcpSettings& settings) {
  const double count = static_cast<double>(std::min<std::int64_t>(steps, 3));
  const double moved_m = last[0].moved_m + last[1].moved_m + last[2].moved_m;
  const double turned_rad = last[0].turned_rad + last[1].turned_rad + last[2].turned_rad;
  return moved_m <= settings.tolerance_m * count &&
         turned_rad <= deg_to_rad(settings.tolerance_deg) * count;
}

/// RMSE over the kept pairs and the share of near ones, at the final pose.
void rate(const TrimmedPairs& pairs, double share_distance_m, Registration& result) {
  double sum_m2 = 0.0;
  for (const std::int32_t k : pairs.kept) {
    sum_m2 += pairs.partner[static_cast<std::size_t>(k)].squared_m2;
  }
  result.rmse_m = std::sqrt(sum_m2 / static_cast<double>(pairs.kept.size()));
  for (const NearestStem& partner : pairs.partner) {
    if (partner.squared_m2 < share_distance_m * share_distance_m) ++result.inliers;
  }
  result.share = result.inliers / static_cast<double>(pairs.partner.size());
}

/// Coordinates so large that their squares overflow.
Registration beyond_numbers(const Pose3& guess) {
  Registration result;
  result.status = RegistrationStatus::kNotFinite;
  result.T_target_source = guess;
  return result;
}

}  // namespace

void describe(SettingsVisitor& v, TrimmedIcpSettings& s) {
  v.field({"inlier_ratio", "", "nearest part of the points that each step is fitted to",
           "Nevalainen2021 §2.3: 1 − γ, γ = 0.6"},
          s.inlier_ratio, Range{0.01, 1.0});
  v.field({"max_iterations", "", "steps at most", "Matlab R2020b: pcregistericp, 30"},
          s.max_iterations, Range{1.0, 1e4});
  v.field({"tolerance_m", "m", "mean movement of the last three steps that ends it",
           "choice: reaches the fixed point; Matlab has 0.01"},
          s.tolerance_m, Range{0.0, 10.0});
  v.field({"tolerance_deg", "deg", "mean turn of the last three steps that ends it",
           "choice: reaches the fixed point; Matlab has 0.5"},
          s.tolerance_deg, Range{0.0, 180.0});
  v.field({"share_distance_m", "m", "a partner nearer than this counts as an inlier",
           "choice: five times the noise of a stem"},
          s.share_distance_m, Range{0.0, 10.0});
}

RegistrationStatus registrable(IcpPoints points_m) {
  for (const Eigen::Vector3d& p : points_m) {
    if (!p.allFinite()) return RegistrationStatus::kNotFinite;
  }
  if (points_m.size() < 3) return RegistrationStatus::kTooFewPoints;
  const auto far = [&](const Eigen::Vector3d& from) {
    return *std::max_element(points_m.begin(), points_m.end(), [&](const auto& a, const auto& b) {
      return (a - from).squaredNorm() < (b - from).squaredNorm();
    });
  };
  const Eigen::Vector3d start = far(points_m[0]);
  const Eigen::Vector3d along = (far(start) - start).stableNormalized();
  for (const Eigen::Vector3d& p : points_m) {
    if (along.cross(p - start).norm() > kLineWidthM) return RegistrationStatus::kRegistered;
  }
  return RegistrationStatus::kTooFewPoints;
}

Registration trimmed_icp(const NearestStems& target, IcpPoints target_m, IcpPoints source_m,
                         const Pose3& T_target_source_guess, const TrimmedIcpSettings& settings) {
  Registration result;
  if (!T_target_source_guess.matrix().allFinite()) {
    result.status = RegistrationStatus::kNotFinite;
    return result;
  }
  Pose3& pose = result.T_target_source = T_target_source_guess;
  result.status = registrable(source_m);
  if (!result.usable()) return result;

  // Nevalainen2021 §2.2: pcregistericp, with the trimming of Chetverikov2002.
  const double part = settings.inlier_ratio * static_cast<double>(source_m.size());
  const auto count =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(part - 1e-9)), 3, source_m.size());
  TrimmedPairs pairs;
  bool moving = pair_nearest(target, target_m, source_m, pose, count, pairs);
  std::array<IcpStep, 3> last{};
  std::int64_t steps = 0;
  while (steps < settings.max_iterations) {
    IcpStep step;
    if (moving) {  // otherwise the same pairs give the same pose again
      const Pose3 next = fit_pairs(target_m, source_m, pairs, pose.linear());
      if (!next.matrix().allFinite()) return beyond_numbers(T_target_source_guess);
      step = step_between(pose, next);
      pose = next;
      moving = pair_nearest(target, target_m, source_m, pose, count, pairs);
    }
    last[static_cast<std::size_t>(steps % 3)] = step;
    ++steps;
    if (at_rest(last, steps, settings)) break;
  }
  result.iterations = static_cast<int>(steps);
  rate(pairs, settings.share_distance_m, result);
  return result;
}

Registration trimmed_icp(IcpPoints target_m, IcpPoints source_m, const Pose3& T_target_source_guess,
                         const TrimmedIcpSettings& settings) {
  const RegistrationStatus status = registrable(target_m);
  if (status != RegistrationStatus::kRegistered) {
    Registration refused;
    refused.status = status;
    if (T_target_source_guess.matrix().allFinite()) {
      refused.T_target_source = T_target_source_guess;
    }
    return refused;
  }
  return trimmed_icp(NearestStems(target_m), target_m, source_m, T_target_source_guess, settings);
}

}  // namespace honka
