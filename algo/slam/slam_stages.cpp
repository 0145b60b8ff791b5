#include "algo/slam/slam_stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "algo/slam/methods/checked_match.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

/// No lidar sees a stem so far away; and a pose so far away is no pose of a drive.
constexpr double kFarthestPoint_m = 1000.0, kFarthestPose_m = 1e6;

/// Inverse within 1e-6 of the transpose: what files of six decimals keep.
constexpr double kRotationTolerance = 1e-5;

bool is_pose(const Pose3& pose) {
  const Eigen::Matrix3d& rotation = pose.linear();
  return (pose.translation().array().abs() < kFarthestPose_m).all() && rotation.allFinite() &&
         (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() <
             kRotationTolerance &&
         rotation.determinant() > 0.0;
}

void check_given(const FramePoses& given, std::size_t frames) {
  if (given.size() != frames) {
    throw UserError(fmt::format("the chain has {} poses and there are {} frames; give one a frame",
                                given.size(), frames));
  }
  const auto bad = std::find_if_not(given.begin(), given.end(), is_pose);
  if (bad != given.end()) {
    throw UserError(fmt::format("pose {} of the chain is no rotation and translation in metres",
                                bad - given.begin()));
  }
}

StageProgress progress_of(SlamWork& work, std::string_view stage) {
  if (work.observer == nullptr) return {};
  return [observer = work.observer, stage](std::size_t done, std::size_t total) {
    observer->during_stage(stage, done, total);
  };
}

}  // namespace

std::vector<SparseFrame> clean_frames(std::span<const SparseFrame> frames,
                                      std::vector<FrameStatus>& statuses) {
  std::vector<SparseFrame> clean(frames.begin(), frames.end());
  statuses.assign(frames.size(), FrameStatus::kPlaced);
  for (std::size_t l = 0; l < clean.size(); ++l) {
    const std::size_t left_out = std::erase_if(clean[l].points_m, [](const Eigen::Vector3d& p) {
      return !(p.array().abs() < kFarthestPoint_m).all();
    });
    if (registrable(clean[l].points_m) != RegistrationStatus::kRegistered) {
      statuses[l] = FrameStatus::kTooFewPoints;
    }
    if (left_out > 0) statuses[l] = FrameStatus::kNotFinite;
  }
  return clean;
}

void stage_chain(SlamWork& work, const std::optional<FramePoses>& given) {
  if (!given) {
    work.poses = make_chain(work.frames, work.settings.chain).T_first_frame;
    return;
  }
  check_given(*given, work.frames.size());
  const Pose3 T_first_given = given->front().inverse();
  for (const Pose3& pose : *given) {
    Pose3 next = T_first_given * pose;
    next.linear() = Eigen::Quaterniond(next.linear()).normalized().toRotationMatrix();
    work.poses.push_back(next);
  }
  work.poses.front() = Pose3::Identity();
}

void stage_rechain(SlamWork& work) {
  const SlamSettings& s = work.settings;
  const Rechain chain = reregister_chain(work.frames, work.poses, s.view, s.match, s.rechain,
                                         progress_of(work, "rechain"));
  work.poses = chain.T_first_frame;
  work.bad_steps.clear();
  for (const StepStatus status : chain.steps) {
    const bool good = status == StepStatus::kRegistered || status == StepStatus::kSearched;
    work.bad_steps.push_back(good ? 0 : 1);
  }
  work.result.bad_steps = chain.bad_steps();
}

void stage_paper_loop(SlamWork& work) {
  const auto observe = [&](const CorrectionReport& report, const FramePoses& poses) {
    if (work.observer != nullptr) work.observer->after_correction(report, poses);
  };
  PaperLoopResult loop = run_paper_loop(work.frames, work.poses, work.settings.view,
                                        work.settings.loop, work.seed, observe);
  work.poses = std::move(loop.T_first_frame);
  work.result.corrections = static_cast<std::size_t>(loop.applied);
  work.result.icp_calls = static_cast<std::size_t>(loop.icp_calls);
  work.result.go_icp_calls = static_cast<std::size_t>(loop.go_icp_calls);
}

void stage_pairs(SlamWork& work) {
  const SlamSettings& s = work.settings;
  VerifiedPairs found = find_verified_pairs(work.frames, work.poses, s.view, s.match, s.pairs);
  work.result.matches = std::move(found.matches);
  work.result.corrections = work.result.matches.size();
  work.result.icp_calls = found.icp_calls;
  work.result.go_icp_calls = s.pairs.global == "go_icp" ? found.global_calls : 0;
}

void stage_interpolate(SlamWork& work) {
  work.poses = interpolate_pairs(work.poses, work.result.matches, work.settings.interpolate);
}

void stage_pose_graph(SlamWork& work) {
  const PoseGraphSettings& s = work.settings.pose_graph;
  auto edges = chain_edges(work.poses, work.bad_steps, s);
  const auto matches = match_edges(work.result.matches, s);
  edges.insert(edges.end(), matches.begin(), matches.end());
  work.poses = optimize_pose_graph(work.poses, edges, s).T_first_frame;
}

void stage_landmark_ba(SlamWork& work) {
  LandmarkBaResult adjusted =
      adjust_landmarks(work.frames, work.poses, work.settings.stem_map, work.settings.landmark_ba,
                       {}, progress_of(work, "landmark_ba"));
  work.poses = std::move(adjusted.T_first_frame);
  work.stems = std::move(adjusted.map);
}

void stage_finish(SlamWork& work) {
  const SlamSettings& s = work.settings;
  if (!work.stems) work.stems = build_stem_map(work.frames, work.poses, s.stem_map);
  work.result.stems = work.stems->stems;
  std::vector<std::uint8_t> holds(work.frames.size() + 1, 0);  // holds[l]: the step to frame l
  for (std::size_t l = 1; l < work.frames.size(); ++l) {
    const MatchQuality quality = judge_match(work.frames[l - 1].points_m, work.frames[l].points_m,
                                             between(work.poses, l - 1, l), s.view, s.match);
    holds[l] = quality.share >= s.rechain.min_share ? 1 : 0;
  }
  for (std::size_t l = 0; l < work.frames.size() && work.frames.size() > 1; ++l) {
    FrameStatus& status = work.result.frames[l];
    const bool held = holds[l] != 0 || holds[l + 1] != 0;
    if (status == FrameStatus::kPlaced && !held) status = FrameStatus::kUnverified;
  }
}

}  // namespace honka
