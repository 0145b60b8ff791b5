// The pose graph: what exact measurements recover, what a wrong one does, what is left out.
#include <catch2/catch.hpp>
#include <limits>

#include "algo/slam/methods/pose_graph.h"
#include "tests/algo/slam/methods_world.h"

namespace {

using namespace honka;
using namespace honka::test;

std::vector<PoseGraphEdge> graph_edges(const FramePoses& chain,
                                       const std::vector<PairMatch>& matches,
                                       const PoseGraphSettings& settings = {}) {
  auto edges = chain_edges(chain, {}, settings);
  const auto more = match_edges(matches, settings);
  edges.insert(edges.end(), more.begin(), more.end());
  return edges;
}

}  // namespace

TEST_CASE("pose graph: exact edges recover the truth from a bent start") {
  const MethodsWorld world = methods_world(120);
  const FramePoses bent = bent_chain(world.T_first_frame, 0.004, 0.02);
  REQUIRE(aligned_error_m(bent, world.T_first_frame) > 0.5);
  const auto edges = graph_edges(world.T_first_frame, true_matches(world.T_first_frame, 30));
  const auto result = optimize_pose_graph(bent, edges, {});
  CHECK(result.converged);
  CHECK(result.final_cost < 1e-12);
  CHECK(largest_difference(result.T_first_frame, world.T_first_frame) < 1e-6);
}

TEST_CASE("pose graph: true matches straighten a bent chain, and a graph at rest stays") {
  const MethodsWorld world = methods_world(160);
  const FramePoses bent = bent_chain(world.T_first_frame, 0.002, 0.01);
  const auto matches = true_matches(world.T_first_frame, 20);
  const auto result = optimize_pose_graph(bent, graph_edges(bent, matches), {});
  const double before_m = aligned_error_m(bent, world.T_first_frame);
  CHECK(aligned_error_m(result.T_first_frame, world.T_first_frame) < 0.1 * before_m);
  const auto alone = optimize_pose_graph(bent, graph_edges(bent, {}), {});
  CHECK(largest_difference(alone.T_first_frame, bent) < 1e-9);
}

TEST_CASE("pose graph: one wrong match among many moves the map by little, without loss by much") {
  const MethodsWorld world = methods_world(160);
  auto matches = true_matches(world.T_first_frame, 20);
  matches.front().T_earlier_later.translation() += Eigen::Vector3d(4.0, -3.0, 0.0);
  const auto edges = graph_edges(world.T_first_frame, matches);
  const auto robust = optimize_pose_graph(world.T_first_frame, edges, {});
  CHECK(aligned_error_m(robust.T_first_frame, world.T_first_frame) < 0.02);
  PoseGraphSettings trusting;
  trusting.robust_scale = 0.0;
  const auto squares = optimize_pose_graph(world.T_first_frame, edges, trusting);
  CHECK(aligned_error_m(squares.T_first_frame, world.T_first_frame) > 0.2);
}

TEST_CASE("pose graph: a bad step gives way where a match says otherwise") {
  const MethodsWorld world = methods_world(100);
  FramePoses broken = world.T_first_frame;
  const Pose3 jump = pose_from_rpy({1.5, 0.5, 0.0}, 0.0, 0.0, 0.3);
  for (std::size_t l = 50; l < broken.size(); ++l) {
    broken[l] = world.T_first_frame[50] * jump *
                (world.T_first_frame[50].inverse() * world.T_first_frame[l]);
  }
  std::vector<std::uint8_t> bad(broken.size() - 1, 0);
  bad[49] = 1;
  PoseGraphSettings settings;
  auto edges = chain_edges(broken, bad, settings);
  const auto matches = match_edges(true_matches(world.T_first_frame, 20), settings);
  edges.insert(edges.end(), matches.begin(), matches.end());
  const auto knowing = optimize_pose_graph(broken, edges, settings);
  CHECK(aligned_error_m(knowing.T_first_frame, world.T_first_frame) < 0.02);
}

TEST_CASE("pose graph: edges that name no pose or hold NaN are left out, few poses are no graph") {
  const MethodsWorld world = methods_world(20);
  auto edges = graph_edges(world.T_first_frame, true_matches(world.T_first_frame, 10));
  const auto clean = optimize_pose_graph(world.T_first_frame, edges, {});
  PoseGraphEdge absent{3, 999, Pose3::Identity(), 0.03, 0.01, true};
  PoseGraphEdge self{4, 4, Pose3::Identity(), 0.03, 0.01, true};
  PoseGraphEdge nan{3, 5, Pose3::Identity(), 0.03, 0.01, true};
  nan.T_target_source.translation().x() = std::numeric_limits<double>::quiet_NaN();
  edges.insert(edges.end(), {absent, self, nan});
  const auto result = optimize_pose_graph(world.T_first_frame, edges, {});
  CHECK(largest_difference(result.T_first_frame, clean.T_first_frame) == 0.0);
  CHECK(optimize_pose_graph({}, {}, {}).T_first_frame.empty());
  CHECK(optimize_pose_graph({Pose3::Identity()}, {}, {}).T_first_frame.size() == 1);
}

TEST_CASE("pose graph: the first pose stays bit for bit and the same call gives the same digits") {
  const MethodsWorld world = methods_world(80);
  const FramePoses bent = bent_chain(world.T_first_frame, 0.003, 0.02);
  const auto edges = graph_edges(bent, true_matches(world.T_first_frame, 16));
  const auto one = optimize_pose_graph(bent, edges, {});
  const auto two = optimize_pose_graph(bent, edges, {});
  CHECK(one.T_first_frame.front().matrix() == bent.front().matrix());
  CHECK(largest_difference(one.T_first_frame, two.T_first_frame) == 0.0);
}
