#include "algo/slam/match_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace honka {
namespace {

/// Squared distances of the source points in the common view to their nearest target points.
std::vector<double> squared_distances_in_view(const NearestStems& target,
                                              std::span<const Eigen::Vector3d> source_m,
                                              const Pose3& T_target_source, const ViewCone& cone) {
  std::vector<double> squared_m2;
  squared_m2.reserve(source_m.size());
  for (const Eigen::Vector3d& point : source_m) {
    const Eigen::Vector3d place = T_target_source * point;
    if (!place.allFinite() || !cone.holds(place.head<2>())) continue;
    squared_m2.push_back(target.nearest(place).squared_m2);
  }
  return squared_m2;
}

/// Root of the mean of the ⌈share · n⌉ smallest; sorts the front of `squared_m2`.
double best_part_rms(std::vector<double>& squared_m2, double share) {
  const auto n = squared_m2.size();
  const double exact = share * static_cast<double>(n);
  const auto kept =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(exact - 1e-9)), 1, n);
  const auto end = squared_m2.begin() + static_cast<std::ptrdiff_t>(kept);
  std::partial_sort(squared_m2.begin(), end, squared_m2.end());
  return std::sqrt(std::accumulate(squared_m2.begin(), end, 0.0) / static_cast<double>(kept));
}

}  // namespace

void describe(SettingsVisitor& v, MatchQualitySettings& s) {
  v.field({"inlier_ratio", "", "best part of the nearest-neighbour distances that e is taken over",
           "Nevalainen2021 §2.3: 1 − γ, γ = 0.6"},
          s.inlier_ratio, Range{0.01, 1.0});
  v.field({"share_distance_m", "m", "a neighbour nearer than this counts for the share",
           "choice: five times the noise of a stem"},
          s.share_distance_m, Range{0.0, 10.0});
  v.field({"min_points", "", "points in the common view below which nothing is judged", "choice"},
          s.min_points, Range{1.0, 1e6});
}

MatchQuality judge_match(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                         const Pose3& T_target_source, const ViewCone& cone,
                         const MatchQualitySettings& settings) {
  std::vector<double> squared_m2 =
      squared_distances_in_view(target, source_m, T_target_source, cone);
  const auto n = static_cast<int>(squared_m2.size());
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (n == 0 || n < settings.min_points || target.size() == 0) return {n, kNone, kNone, 0.0};

  MatchQuality quality{n, 0.0, 0.0, 0.0};
  const double near_m2 = settings.share_distance_m * settings.share_distance_m;
  for (const double squared : squared_m2) {
    quality.mean_m += std::sqrt(squared) / n;
    quality.share += squared < near_m2 ? 1.0 : 0.0;
  }
  quality.share /= n;
  quality.error_m = best_part_rms(squared_m2, settings.inlier_ratio);
  return quality;
}

MatchQuality judge_match(std::span<const Eigen::Vector3d> target_m,
                         std::span<const Eigen::Vector3d> source_m, const Pose3& T_target_source,
                         const ViewCone& cone, const MatchQualitySettings& settings) {
  std::vector<Eigen::Vector3d> finite_m;
  finite_m.reserve(target_m.size());
  for (const Eigen::Vector3d& point : target_m) {
    if (point.allFinite()) finite_m.push_back(point);
  }
  return judge_match(NearestStems(finite_m), source_m, T_target_source, cone, settings);
}

}  // namespace honka
