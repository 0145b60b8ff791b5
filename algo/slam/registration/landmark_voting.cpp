#include "algo/slam/registration/landmark_voting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/slam/registration/landmark_triangles.h"
#include "algo/slam/registration/share_test.h"
#include "algo/slam/registration/vote_places.h"

namespace honka {
namespace {

/// Reaches within which partners are sought, from a place in the table of votes to the noise of
/// stems; the last one is the share distance.
constexpr std::array<double, 4> kRefineReaches_m = {1.2, 0.8, 0.5, 0.5};
constexpr int kMostRefinements = 6;  // at the last reach

struct LandmarkClouds {
  std::vector<Eigen::Vector2d> target_m, source_m;  ///< each about its middle
  Eigen::Vector2d target_middle_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d source_middle_m = Eigen::Vector2d::Zero();
};

Eigen::Vector2d take_middle(std::span<const Eigen::Vector3d> points_m,
                            std::vector<Eigen::Vector2d>& centred_m) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : points_m) {
    middle += p.head<2>() / static_cast<double>(points_m.size());
  }
  for (const Eigen::Vector3d& p : points_m) centred_m.emplace_back(p.head<2>() - middle);
  return middle;
}

struct RefinedPlace {
  Pose2 pose;
  std::size_t partners = 0;
};

/// Fits the pose to the partners within ever shorter reaches.
RefinedPlace refine(const NearestStems& target, const LandmarkClouds& clouds, Pose2 pose,
                    double last_reach_m) {
  std::vector<Eigen::Vector2d> to, from;
  const auto pair_up = [&](double reach_m) {
    to.clear();
    from.clear();
    for (const Eigen::Vector2d& p : clouds.source_m) {
      const auto nearest = target.nearest_planar(pose * p);
      if (nearest.squared_m2 >= reach_m * reach_m) continue;
      to.push_back(clouds.target_m[static_cast<std::size_t>(nearest.index)]);
      from.push_back(p);
    }
    return to.size();
  };
  constexpr std::size_t kFewest = 3;
  for (const double reach_m : kRefineReaches_m) {
    if (pair_up(std::max(reach_m, last_reach_m)) < kFewest) return {pose, 0};
    pose = fit_planar(to, from);
  }
  std::size_t before = 0;
  for (int round = 0; round < kMostRefinements; ++round) {
    const std::size_t partners = pair_up(last_reach_m);
    if (partners < kFewest || partners == before) break;
    before = partners;
    pose = fit_planar(to, from);
  }
  return {pose, pair_up(last_reach_m)};
}

/// The refined place with the most partners; none where nothing voted.
RefinedPlace best_place(const NearestStems& target, const LandmarkClouds& clouds,
                        const LandmarkVotingSettings& settings) {
  const auto votes = triangle_votes(
      clouds.target_m, landmark_triangles(clouds.target_m, settings.neighbours), clouds.source_m,
      landmark_triangles(clouds.source_m, settings.neighbours), settings.side_tolerance_m);
  RefinedPlace best;
  for (const Pose2& place : most_voted(votes, static_cast<std::size_t>(settings.candidates))) {
    const RefinedPlace refined = refine(target, clouds, place, settings.share_distance_m);
    if (refined.partners > best.partners) best = refined;
    if (3 * best.partners >= clouds.source_m.size()) break;  // chance gives a tenth
  }
  return best;
}

/// From the clouds about their middles to the clouds.
Pose3 uncentred(const Pose2& pose, const LandmarkClouds& clouds) {
  Pose3 T_target_source = pose_from_rpy(Eigen::Vector3d::Zero(), 0.0, 0.0, pose.yaw_rad);
  T_target_source.translation().head<2>() =
      clouds.target_middle_m + pose * Eigen::Vector2d(-clouds.source_middle_m);
  return T_target_source;
}

}  // namespace

void describe(SettingsVisitor& v, LandmarkVotingSettings& s) {
  v.field({"neighbours", "", "nearest stems that form triangles with each stem", "choice"},
          s.neighbours, Range{2.0, 50.0});
  v.field({"side_tolerance_m", "m", "by which the sides of two triangles may differ",
           "choice: twice the noise of a difference of sides"},
          s.side_tolerance_m, Range{0.001, 10.0});
  v.field({"candidates", "", "places with the most votes that are verified", "choice"},
          s.candidates, Range{1.0, 1000.0});
  v.field({"inlier_share", "", "best part of the source points, for the RMSE alone",
           "Nevalainen2021 §2.3: 1 − γ, γ = 0.6"},
          s.inlier_share, Range{0.01, 1.0});
  v.field({"share_distance_m", "m", "a neighbour nearer than this counts for the share",
           "choice: five times the noise of a stem"},
          s.share_distance_m, Range{0.01, 10.0});
  v.field({"min_share", "", "of the source points in the common view, or the pose is refused",
           "choice: right poses lie above, wrong ones below"},
          s.min_share, Range{0.0, 1.0});
  v.field({"min_evidence", "nat", "by which partners must be more than chance gives, or refused",
           "choice: 14 for a million poses, and a margin"},
          s.min_evidence, Range{0.0, 1e6});
}

Registration register_by_landmarks(std::span<const Eigen::Vector3d> target_m,
                                   std::span<const Eigen::Vector3d> source_m,
                                   const LandmarkVotingSettings& settings,
                                   const std::optional<ViewCone>& cone) {
  Registration result;
  result.status = registrable_in_plane(target_m, source_m);
  if (result.status != RegistrationStatus::kRegistered) return result;

  LandmarkClouds clouds;
  clouds.target_middle_m = take_middle(target_m, clouds.target_m);
  clouds.source_middle_m = take_middle(source_m, clouds.source_m);
  std::vector<Eigen::Vector3d> flat_target_m;
  for (const Eigen::Vector2d& p : clouds.target_m) flat_target_m.emplace_back(p.x(), p.y(), 0.0);
  const RefinedPlace place = best_place(NearestStems(flat_target_m), clouds, settings);

  const NearestStems target(target_m);
  if (place.partners > 0) {
    result.T_target_source = with_tilt(target_m, target, source_m, uncentred(place.pose, clouds),
                                       settings.share_distance_m);
  }
  const CommonView view(target_m, cone, settings.share_distance_m);
  judge_share(target, source_m, view,
              {settings.share_distance_m, settings.min_share, settings.min_evidence}, result);
  result.rmse_m =
      trimmed_planar_rmse(target, source_m, result.T_target_source, settings.inlier_share);
  return result;
}

}  // namespace honka
