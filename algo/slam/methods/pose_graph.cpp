#include "algo/slam/methods/pose_graph.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "algo/slam/chain.h"
#include "algo/types/angles.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// A pose as Ceres moves it: quaternion x, y, z, w and translation.
struct GraphNode {
  explicit GraphNode(const Pose3& pose) {
    const Eigen::Quaterniond rotation(pose.linear());
    Eigen::Map<Eigen::Vector4d>(q.data()) = rotation.coeffs();
    Eigen::Map<Eigen::Vector3d>(t.data()) = pose.translation();
  }
  [[nodiscard]] Pose3 pose() const {
    Pose3 result = Pose3::Identity();
    result.linear() = Eigen::Map<const Eigen::Quaterniond>(q.data()).normalized().matrix();
    result.translation() = Eigen::Map<const Eigen::Vector3d>(t.data());
    return result;
  }
  std::array<double, 4> q{};
  std::array<double, 3> t{};
};

/// Measured against held motion: T_target_source⁻¹ T_first_target⁻¹ T_first_source, its
/// translation and rotation vector (2 sin θ/2 ≈ θ) in standard deviations.
struct EdgeResidual {
  explicit EdgeResidual(const PoseGraphEdge& edge)
      : rotation(edge.T_target_source.linear()),
        translation(edge.T_target_source.translation()),
        per_m(1.0 / edge.sigma_m),
        per_rad(1.0 / edge.sigma_rad) {}

  template <class T>
  bool operator()(const T* q_target, const T* t_target, const T* q_source, const T* t_source,
                  T* residual) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Eigen::Map<const Eigen::Quaternion<T>> target(q_target), source(q_source);
    const Eigen::Map<const Vector> from(t_target), to(t_source);
    const Eigen::Quaternion<T> turn = rotation.cast<T>().conjugate() * target.conjugate() * source;
    const Vector step = target.conjugate() * Vector(to - from) - translation.cast<T>();
    const T sign = turn.w() < T(0.0) ? T(-2.0) : T(2.0);
    Eigen::Map<Vector> out_m(residual), out_rad(residual + 3);
    out_m = (rotation.conjugate().cast<T>() * step) * T(per_m);
    out_rad = turn.vec() * (sign * T(per_rad));
    return true;
  }

  Eigen::Quaterniond rotation;
  Eigen::Vector3d translation;
  double per_m, per_rad;
};

bool usable_edge(const PoseGraphEdge& edge, std::size_t poses) {
  return edge.target < poses && edge.source < poses && edge.target != edge.source &&
         edge.T_target_source.matrix().allFinite() && edge.sigma_m > 0.0 && edge.sigma_rad > 0.0;
}

bool all_finite_poses(const FramePoses& poses) {
  return std::all_of(poses.begin(), poses.end(),
                     [](const Pose3& pose) { return pose.matrix().allFinite(); });
}

void add_nodes(std::vector<GraphNode>& nodes, ceres::Problem& problem, ceres::Manifold* manifold) {
  for (GraphNode& node : nodes) {
    problem.AddParameterBlock(node.q.data(), 4, manifold);
    problem.AddParameterBlock(node.t.data(), 3);
  }
  problem.SetParameterBlockConstant(nodes.front().q.data());
  problem.SetParameterBlockConstant(nodes.front().t.data());
}

ceres::Solver::Options graph_options(const PoseGraphSettings& settings) {
  constexpr double kTolerance = 1e-10;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  // Eigen's factorization has the same digits on every machine; SuiteSparse's depends on the BLAS.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = static_cast<int>(settings.max_iterations);
  options.function_tolerance = kTolerance;
  options.parameter_tolerance = kTolerance;
  options.gradient_tolerance = kTolerance;
  options.logging_type = ceres::SILENT;
  return options;
}

/// One solution of the graph from where its nodes are, with the given loss on robust edges.
ceres::Solver::Summary solve_graph(std::vector<GraphNode>& nodes,
                                   std::span<const PoseGraphEdge> edges, ceres::LossFunction* loss,
                                   const PoseGraphSettings& settings) {
  ceres::EigenQuaternionManifold manifold;
  ceres::Problem::Options ownership;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  add_nodes(nodes, problem, &manifold);
  for (const PoseGraphEdge& edge : edges) {
    if (!usable_edge(edge, nodes.size())) continue;
    GraphNode& target = nodes[edge.target];
    GraphNode& source = nodes[edge.source];
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<EdgeResidual, 6, 4, 3, 4, 3>(new EdgeResidual(edge)),
        edge.robust ? loss : nullptr, target.q.data(), target.t.data(), source.q.data(),
        source.t.data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(graph_options(settings), &problem, &summary);
  return summary;
}

}  // namespace

std::vector<PoseGraphEdge> chain_edges(const FramePoses& T_first_frame,
                                       std::span<const std::uint8_t> bad_steps,
                                       const PoseGraphSettings& settings) {
  std::vector<PoseGraphEdge> edges;
  for (std::size_t l = 0; l + 1 < T_first_frame.size(); ++l) {
    const bool bad = l < bad_steps.size() && bad_steps[l] != 0;
    const double factor = bad ? settings.bad_step_factor : 1.0;
    edges.push_back({l, l + 1, between(T_first_frame, l, l + 1), settings.chain_m * factor,
                     deg_to_rad(settings.chain_deg) * factor, false});
  }
  return edges;
}

std::vector<PoseGraphEdge> match_edges(std::span<const PairMatch> matches,
                                       const PoseGraphSettings& settings) {
  std::vector<PoseGraphEdge> edges;
  for (const PairMatch& match : matches) {
    edges.push_back({match.earlier, match.later, match.T_earlier_later, settings.match_m,
                     deg_to_rad(settings.match_deg), true});
  }
  return edges;
}

PoseGraphResult optimize_pose_graph(const FramePoses& start, std::span<const PoseGraphEdge> edges,
                                    const PoseGraphSettings& settings) {
  HONKA_CHECK(all_finite_poses(start), "the poses of a graph must be finite");
  PoseGraphResult result;
  result.T_first_frame = start;
  if (start.size() < 2) {
    result.converged = true;
    return result;
  }
  std::vector<GraphNode> nodes;
  for (const Pose3& pose : start) nodes.emplace_back(pose);

  // A convex loss first: from a bent chain even right matches look like outliers to Cauchy's.
  std::unique_ptr<ceres::LossFunction> convex, redescending;
  if (settings.robust_scale > 0.0) {
    convex = std::make_unique<ceres::HuberLoss>(settings.robust_scale);
    redescending = std::make_unique<ceres::CauchyLoss>(settings.robust_scale);
  }
  const auto rough = solve_graph(nodes, edges, convex.get(), settings);
  const auto fine = solve_graph(nodes, edges, redescending.get(), settings);
  result.converged = fine.termination_type == ceres::CONVERGENCE;
  result.iterations = static_cast<int>(rough.iterations.size() + fine.iterations.size());
  result.initial_cost = rough.initial_cost;
  result.final_cost = fine.final_cost;

  FramePoses solved;
  for (const GraphNode& node : nodes) solved.push_back(node.pose());
  if (!rough.IsSolutionUsable() || !fine.IsSolutionUsable() || !all_finite_poses(solved)) {
    result.converged = false;
    return result;
  }
  solved.front() = start.front();
  result.T_first_frame = std::move(solved);
  return result;
}

}  // namespace honka
