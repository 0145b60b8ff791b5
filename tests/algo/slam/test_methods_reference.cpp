// The reference case: re-registered chain, verified pairs, interpolation, pose graph, adjustment.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "algo/slam/chain.h"
#include "algo/slam/map_quality/blur.h"
#include "algo/slam/slam.h"
#include "tests/algo/slam/methods_world.h"
#include "tests/support/slam_case.h"

namespace {

using namespace honka;
using namespace honka::test;

const InterpolatePairsSettings kLeftPairs;
const VerifiedPairsSettings kCasePairs;

/// Case 0 as the methods see it, and its truth for the judgement.
struct MethodsCase {
  std::vector<SparseFrame> frames;
  FramePoses chain, rechain, truth;
  std::vector<PairMatch> matches;
  nlohmann::json reference;
};

/// Read once; nothing where the shared data are absent.
const MethodsCase* methods_case() {
  static const auto loaded = []() -> std::optional<MethodsCase> {
    const auto folder = shared_slam_cases();
    if (!folder) return std::nullopt;
    MethodsCase result;
    for (auto& points : read_frame_points(*folder / "case0_points.csv.gz")) {
      const auto number = static_cast<std::int64_t>(result.frames.size());
      result.frames.push_back({number, std::move(points)});
    }
    result.chain = read_pose_rows(*folder / "case0_chain_pose.csv");
    result.rechain = read_pose_rows(*folder / "case0_rechain_pose.csv");
    result.truth = read_pose_rows(*folder / "case0_true_pose.csv");
    const auto rows = read_number_rows(*folder / "case0_ms_pairs.csv");
    const auto poses = read_pose_rows(*folder / "case0_ms_pairs.csv", 2);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      result.matches.push_back({static_cast<std::size_t>(rows[k][1]),
                                static_cast<std::size_t>(rows[k][0]), poses[k], 0.0, 0.0});
    }
    std::ifstream file(*folder / "case0_reference.json");
    result.reference = nlohmann::json::parse(file).at("reference_ms");
    return result;
  }();
  return loaded ? &*loaded : nullptr;
}

double blur_of(const MethodsCase& world, const FramePoses& poses) {
  return blur(map_points(world.frames, poses), {});
}

void check_near(const MethodsCase& world, const FramePoses& poses, const std::string& name) {
  INFO(name);
  const auto& row = world.reference.at(name);
  CHECK(blur_of(world, poses) == Approx(row.at("beta").get<double>()).epsilon(0.02));
  CHECK(aligned_error_m(poses, world.truth) == Approx(row.at("ate").get<double>()).epsilon(0.10));
}

}  // namespace

TEST_CASE("methods on case 0: the shared matches give the reference's interpolation and graph") {
  const auto* world = methods_case();
  if (world == nullptr) {
    WARN("the shared SLAM case is absent");
    return;
  }
  InterpolatePairsSettings right;
  right.side = "right";
  check_near(*world, interpolate_pairs(world->rechain, world->matches, right), "interp_right");
  InterpolatePairsSettings left;
  left.side = "left";
  check_near(*world, interpolate_pairs(world->rechain, world->matches, left), "interp_left");
  PoseGraphSettings settings;
  auto edges = chain_edges(world->rechain, {}, settings);
  const auto more = match_edges(world->matches, settings);
  edges.insert(edges.end(), more.begin(), more.end());
  const auto robust = optimize_pose_graph(world->rechain, edges, settings);
  check_near(*world, robust.T_first_frame, "pgo");
  settings.robust_scale = 0.0;
  const auto squares = optimize_pose_graph(world->rechain, edges, settings);
  check_near(*world, squares.T_first_frame, "pgo_nonrobust");
}

TEST_CASE("methods on case 0: a pair list that names absent frames leaves the rest as it was") {
  const auto* world = methods_case();
  if (world == nullptr) {
    WARN("the shared SLAM case is absent");
    return;
  }
  auto matches = world->matches;
  matches.push_back({7, 99999, Pose3::Identity(), 0.0, 0.0});
  matches.push_back({50, 50, Pose3::Identity(), 0.0, 0.0});
  const auto with = interpolate_pairs(world->rechain, matches, kLeftPairs);
  const auto without = interpolate_pairs(world->rechain, world->matches, kLeftPairs);
  CHECK(largest_difference(with, without) == 0.0);
}

TEST_CASE("methods on case 0: the chain re-registered is good at every step") {
  const auto* world = methods_case();
  if (world == nullptr) {
    WARN("the shared SLAM case is absent");
    return;
  }
  const Rechain chain = reregister_chain(world->frames, world->chain, {}, {}, {});
  CHECK(chain.bad_steps() == 0);
  CHECK(blur_of(*world, chain.T_first_frame) <= 0.033);
  CHECK(aligned_error_m(chain.T_first_frame, world->truth) <= 0.25);
  const auto pairs = find_verified_pairs(world->frames, chain.T_first_frame, {}, {}, kCasePairs);
  CHECK(pairs.matches.size() >= 70);
  CHECK(pairs.matches.size() <= 86);
  for (const PairMatch& match : pairs.matches) {
    const Pose3 off =
        match.T_earlier_later.inverse() * between(world->truth, match.earlier, match.later);
    CHECK(off.translation().norm() < 0.3);
  }
  const FramePoses squeezed = interpolate_pairs(chain.T_first_frame, pairs.matches, kLeftPairs);
  CHECK(blur_of(*world, squeezed) <= 0.028);
  CHECK(aligned_error_m(squeezed, world->truth) <= 0.12);
}

TEST_CASE("methods on case 0: the whole way from the chain reaches its figures") {
  const auto* world = methods_case();
  if (world == nullptr) {
    WARN("the shared SLAM case is absent");
    return;
  }
  struct GraphNotes : SlamObserver {
    void after_stage(std::string_view stage, const FramePoses& poses) override {
      if (stage == "pose_graph") graph = poses;
    }
    FramePoses graph;
  } notes;
  const SlamSettings settings;
  const SlamResult result = run_slam(world->frames, world->chain, settings, &notes);
  CHECK(blur_of(*world, notes.graph) <= 0.027);
  CHECK(aligned_error_m(notes.graph, world->truth) <= 0.07);
  CHECK(blur_of(*world, result.T_first_frame) <= 0.027);
  CHECK(aligned_error_m(result.T_first_frame, world->truth) <= 0.025);
}
