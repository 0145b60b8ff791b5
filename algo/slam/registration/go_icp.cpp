#include "algo/slam/registration/go_icp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algo/slam/convergence.h"
#include "algo/slam/registration/go_icp_search.h"
#include "algo/slam/registration/share_test.h"
#include "algo/slam/registration/trimmed_icp.h"

namespace honka {
namespace {

constexpr double kSlab_deg = 2.0;       // half width of the slabs of yaw a search begins with
constexpr double kReach_m = 10.0;       // of the grid beyond the target; queries farther are slow
constexpr double kFinestLeaf_m = 0.01;  // below this a leaf is no grid for ICP any more
constexpr double kFinestLeaf_deg = 0.01;

using GoIcpCloud = std::span<const Eigen::Vector3d>;

/// Both clouds in the plane, at the initial guess, about the middle of the source: turns about the
/// middle move the points least, so bounds are tightest.
struct CentredClouds {
  std::vector<Eigen::Vector2d> target_m, source_m;
  Eigen::Vector2d middle_in_target_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d pivot_m = Eigen::Vector2d::Zero();  ///< what the region's turns are about
};

CentredClouds centre(GoIcpCloud target_m, GoIcpCloud source_m, const Pose3& T_target_source) {
  CentredClouds clouds;
  for (const Eigen::Vector3d& p : source_m) {
    clouds.source_m.emplace_back((T_target_source * p).head<2>());
    clouds.middle_in_target_m += clouds.source_m.back() / static_cast<double>(source_m.size());
  }
  double radius_m = 0.0;
  for (Eigen::Vector2d& p : clouds.source_m) {
    p -= clouds.middle_in_target_m;
    radius_m = std::max(radius_m, p.norm());
  }
  for (const Eigen::Vector3d& p : target_m) {
    clouds.target_m.emplace_back(p.head<2>() - clouds.middle_in_target_m);
  }
  // The region turns about the sensor; about the cloud where the sensor is none of its frame.
  const Eigen::Vector2d sensor = T_target_source.translation().head<2>();
  if ((sensor - clouds.middle_in_target_m).norm() <= 2.0 * radius_m) {
    clouds.pivot_m = sensor - clouds.middle_in_target_m;
  }
  return clouds;
}

/// Half widths of a leaf; 0 where there are none.
MotionBox leaf_of(const GoIcpSettings& settings, GoIcpCloud target_m) {
  MotionBox leaf;
  if (settings.mode != "l0") return leaf;
  double shift_m = settings.leaf_translation_m;
  double yaw_deg = settings.leaf_yaw_deg;
  if (shift_m <= 0.0 || yaw_deg <= 0.0) {
    // Nevalainen2021 §2.3: σ_t = δ0 and σ_r = θ0.
    const auto limits = convergence_limits(mean_neighbour_distance_m(target_m),
                                           1.0 - settings.inlier_share, settings.range_m);
    if (shift_m <= 0.0) shift_m = limits.translation_m;
    if (yaw_deg <= 0.0) yaw_deg = rad_to_deg(limits.rotation_rad);
  }
  leaf.half_shift_m.setConstant(std::max(shift_m, kFinestLeaf_m));
  leaf.half_yaw_rad = deg_to_rad(std::max(yaw_deg, kFinestLeaf_deg));
  return leaf;
}

/// Slabs of yaw that together hold the search region. A turn about the sensor moves the middle of
/// the source along an arc, so each slab has its own square of shifts, widened by what is left of
/// the arc within it.
std::vector<MotionBox> search_region(const GoIcpSettings& settings, const MotionBox& leaf,
                                     const Eigen::Vector2d& pivot_m) {
  const double half_slab = leaf.half_yaw_rad > 0.0 ? leaf.half_yaw_rad : deg_to_rad(kSlab_deg);
  const double half_yaw = deg_to_rad(settings.search_yaw_deg);
  const int slabs = std::max(1, static_cast<int>(std::ceil(half_yaw / half_slab - 1e-9)));
  std::vector<MotionBox> region;
  for (int k = 0; k < slabs; ++k) {
    MotionBox box;
    box.half_yaw_rad = half_yaw / slabs;
    box.middle.yaw_rad = half_yaw * (2.0 * k + 1.0 - slabs) / slabs;
    box.middle.shift_m = pivot_m - Eigen::Rotation2Dd(box.middle.yaw_rad) * pivot_m;
    const double arc_m =
        2.0 * std::sin(std::min(0.5 * box.half_yaw_rad, 0.5 * std::numbers::pi)) * pivot_m.norm();
    box.half_shift_m.setConstant(settings.search_translation_m + arc_m);
    region.push_back(box);
  }
  return region;
}

/// A motion about the middle of the source as a transform of the target frame.
Pose3 in_target(const PlanarMotion& motion, const Eigen::Vector2d& middle_m) {
  Pose3 transform = pose_from_rpy(Eigen::Vector3d::Zero(), 0.0, 0.0, motion.yaw_rad);
  transform.translation().head<2>() =
      middle_m + motion.shift_m - Eigen::Rotation2Dd(motion.yaw_rad) * middle_m;
  return transform;
}

void describe_search(SettingsVisitor& v, GoIcpSettings& s) {
  v.field({"mode", "", "certify: until the gap is closed; l0: ICP in each leaf of the paper's size",
           "certify: choice; l0: Nevalainen2021 §2.3"},
          s.mode, {"certify", "l0"});
  v.field({"search_yaw_deg", "deg", "yaw searched either way about the guess",
           "Nevalainen2021 §2.3: ±30°"},
          s.search_yaw_deg, Range{0.0, 180.0});
  v.field({"search_translation_m", "m", "x and y searched either way about the guess",
           "Nevalainen2021 §3: 10 × 10 m"},
          s.search_translation_m, Range{0.0, 1000.0});
  v.field(
      {"inlier_share", "", "best part of the source points, 1 − γ", "Nevalainen2021 §2.3: γ = 0.6"},
      s.inlier_share, Range{0.01, 1.0});
  v.field({"gap_m", "m", "certify: largest gap in the trimmed RMSE", "choice: half a stem's noise"},
          s.gap_m, Range{0.001, 10.0});
  v.field({"leaf_translation_m", "m", "l0: half side of a leaf; 0 is δ0 of the target",
           "Nevalainen2021 Eq. (24)"},
          s.leaf_translation_m, Range{0.0, 1000.0});
  v.field({"leaf_yaw_deg", "deg", "l0: half width of a leaf; 0 is θ0 of the target",
           "Nevalainen2021 Eq. (25)"},
          s.leaf_yaw_deg, Range{0.0, 180.0});
  v.field({"range_m", "m", "l0: R of θ0", "Nevalainen2021 §2.3: 35 m"}, s.range_m,
          Range{1.0, 1000.0});
}

void describe_answer(SettingsVisitor& v, GoIcpSettings& s) {
  v.field({"time_cap_s", "s", "wall clock after which the best so far is the answer; 0 is off",
           "choice"},
          s.time_cap_s, Range{0.0, 1e5});
  v.field({"node_cap", "", "the same by boxes bounded: equal on every machine; 0 is off", "choice"},
          s.node_cap, Range{0.0, 1e12});
  v.field({"share_distance_m", "m", "a neighbour nearer than this counts for the share",
           "choice: five times the noise of a stem"},
          s.share_distance_m, Range{0.01, 10.0});
  v.field({"min_share", "", "of the source points in the common view, or the pose is refused",
           "choice: right poses lie above, wrong ones below"},
          s.min_share, Range{0.0, 1.0});
  v.field({"min_evidence", "nat", "by which partners must be more than chance gives, or refused",
           "choice: 14 for a million poses, and a margin"},
          s.min_evidence, Range{0.0, 1e6});
  v.field({"tilt", "", "roll, pitch and z by a last fit to the partners' heights", "choice"},
          s.tilt);
}

}  // namespace

void describe(SettingsVisitor& v, GoIcpSettings& s) {
  describe_search(v, s);
  describe_answer(v, s);
}

Registration go_icp(GoIcpCloud target_m, GoIcpCloud source_m, const Pose3& T_target_source_initial,
                    const GoIcpSettings& settings, const std::optional<ViewCone>& cone) {
  Registration result;
  result.status = RegistrationStatus::kNotFinite;
  if (!T_target_source_initial.matrix().allFinite()) return result;
  result.T_target_source = T_target_source_initial;
  result.status = registrable_in_plane(target_m, source_m);
  if (result.status != RegistrationStatus::kRegistered) return result;

  const CentredClouds clouds = centre(target_m, source_m, T_target_source_initial);
  const std::size_t inliers = inlier_count(settings.inlier_share, source_m.size());
  TrimmedObjective objective(clouds.target_m, clouds.source_m, inliers, kReach_m);

  const MotionBox leaf = leaf_of(settings, target_m);
  const auto region = search_region(settings, leaf, clouds.pivot_m);
  const SearchLimits limits{settings.gap_m, leaf, settings.time_cap_s, settings.node_cap};
  const SearchResult found = branch_and_bound(objective, region, PlanarMotion{}, limits);

  const NearestStems target(target_m);
  result.T_target_source =
      in_target(found.best, clouds.middle_in_target_m) * T_target_source_initial;
  if (settings.tilt) {
    result.T_target_source =
        with_tilt(target_m, target, source_m, result.T_target_source, settings.share_distance_m);
  }
  const CommonView view(target_m, cone, settings.share_distance_m);
  judge_share(target, source_m, view,
              {settings.share_distance_m, settings.min_share, settings.min_evidence}, result);
  if (found.capped) result.status = RegistrationStatus::kTimeCap;
  result.rmse_m =
      trimmed_planar_rmse(target, source_m, result.T_target_source, settings.inlier_share);
  result.lower_bound_m = found.lower_m;
  result.gap_m = found.best_m - found.lower_m;
  result.certified = result.gap_m <= settings.gap_m;
  result.nodes = found.nodes;
  result.iterations = found.icp_steps;
  return result;
}

}  // namespace honka
