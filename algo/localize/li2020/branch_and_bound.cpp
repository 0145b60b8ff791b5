#include "algo/localize/li2020/branch_and_bound.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "algo/types/check.h"

namespace honka {
namespace {

/// The vertices of all matches, and the reach of each: how far a turn can move it.
struct BoundVertices {
  explicit BoundVertices(const std::vector<PoseCandidate>& candidates) {
    for (const PoseCandidate& c : candidates) {
      local_m.insert(local_m.end(), c.local_m.begin(), c.local_m.end());
      map_m.insert(map_m.end(), c.map_m.begin(), c.map_m.end());
    }
    for (const Eigen::Vector2d& v : local_m) reach_m += v.norm();
  }

  std::vector<Eigen::Vector2d> local_m, map_m;
  double reach_m = 0.0;  ///< sum of |V|
};

/// A box of poses about a centre; the turn is relative to the reference of B.
struct BoundNode {
  Eigen::Vector3d centre;  ///< x, y, turn
  Eigen::Vector3d half;
  double bound_m = 0.0;
  double cost_m = 0.0;  ///< of the centre

  /// The least bound first; equal ones by place, so that one order is the only one.
  bool operator<(const BoundNode& other) const {
    if (bound_m != other.bound_m) return bound_m > other.bound_m;
    return std::lexicographical_compare(centre.begin(), centre.end(), other.centre.begin(),
                                        other.centre.end());
  }
};

/// Moves a point at most so far, by any pose of the box from that of its centre.
double turn_way_m(double half_turn_rad, double reach_m) {
  return 2.0 * std::sin(0.5 * std::min(half_turn_rad, kPi)) * reach_m;
}

/// Cost of the centre, and the bound of the box.
void bound_node(const BoundVertices& vertices, double reference_rad, BoundNode& node) {
  const Pose2 T(node.centre.head<2>(), reference_rad + node.centre.z());
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(T.yaw_rad).toRotationMatrix();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  node.cost_m = 0.0;
  for (std::size_t i = 0; i < vertices.local_m.size(); ++i) {
    const Eigen::Vector2d residual = R * vertices.local_m[i] + T.translation_m - vertices.map_m[i];
    const double length_m = residual.norm();
    node.cost_m += length_m;
    if (length_m > 0.0) slope += residual / length_m;  // 0 is a subgradient where it vanishes
  }
  const double shift_m = slope.cwiseAbs().dot(node.half.head<2>());
  node.bound_m = std::max(node.cost_m - shift_m - turn_way_m(node.half.z(), vertices.reach_m), 0.0);
}

/// Whether no pose of the box is allowed.
bool is_outside(const PlaceLimit& limit, double reference_rad, const BoundNode& node) {
  const Pose2 T(node.centre.head<2>(), reference_rad + node.centre.z());
  const double slack_m =
      node.half.head<2>().norm() + turn_way_m(node.half.z(), limit.local_m.norm());
  return (T * limit.local_m - limit.map_m).norm() > limit.radius_m + slack_m;
}

/// The side whose halving tells most: metres, the turn by how far it moves a mean vertex.
int widest_side(const BoundVertices& vertices, const BoundNode& node) {
  const double mean_reach_m = vertices.reach_m / static_cast<double>(vertices.local_m.size());
  Eigen::Vector3d sides = node.half;
  sides.z() = turn_way_m(node.half.z(), 2.0 * mean_reach_m);
  int widest = 0;
  sides.maxCoeff(&widest);
  return widest;
}

BoundNode whole_box(const CandidateBox& box) {
  BoundNode node;
  node.centre << 0.5 * (box.low_m + box.high_m), 0.5 * (box.low_rad + box.high_rad);
  node.half << 0.5 * (box.high_m - box.low_m), 0.5 * (box.high_rad - box.low_rad);
  return node;
}

/// The search: boxes by least bound, the best pose so far, and its reference of angles.
class BoundSearch {
 public:
  BoundSearch(const std::vector<PoseCandidate>& candidates, const std::optional<PlaceLimit>& limit,
              const Selection& start)
      : vertices_(candidates),
        limit_(limit),
        reference_rad_(candidates[start.chosen].T_map_local.yaw_rad),
        best_(start) {
    BoundNode root = whole_box(CandidateBox(candidates, reference_rad_));
    bound_node(vertices_, reference_rad_, root);
    open_.push(root);
  }

  [[nodiscard]] const Selection& best() const { return best_; }
  [[nodiscard]] double lower_bound_m() const {
    return open_.empty() ? best_.cost_m : std::min(open_.top().bound_m, best_.cost_m);
  }

  /// Halves the box of least bound.
  void split() {
    const BoundNode node = open_.top();
    open_.pop();
    const int side = widest_side(vertices_, node);
    for (const double sign : {-1.0, 1.0}) {
      BoundNode child = node;
      child.half[side] *= 0.5;
      child.centre[side] += sign * child.half[side];
      bound_node(vertices_, reference_rad_, child);
      child.bound_m = std::max(child.bound_m, node.bound_m);
      if (!limit_ || !is_outside(*limit_, reference_rad_, child)) take(child);
    }
  }

 private:
  void take(const BoundNode& node) {
    const Pose2 T(node.centre.head<2>(), wrap_to_pi(reference_rad_ + node.centre.z()));
    if (node.cost_m < best_.cost_m && (!limit_ || limit_->allows(T))) {
      best_.T_map_local = T;
      best_.cost_m = node.cost_m;
    }
    if (node.bound_m < best_.cost_m) open_.push(node);
  }

  BoundVertices vertices_;
  std::optional<PlaceLimit> limit_;
  double reference_rad_;
  Selection best_;
  std::priority_queue<BoundNode> open_;
};

}  // namespace

BoundedSelection select_by_bound(const std::vector<PoseCandidate>& candidates,
                                 const std::optional<PlaceLimit>& limit,
                                 const BoundSettings& settings) {
  HONKA_CHECK(!candidates.empty(), "a choice among no candidates");
  const double gap_m = settings.gap_m * 6.0 * static_cast<double>(candidates.size());
  BoundSearch search(candidates, limit, select_in_box(candidates, limit));
  BoundedSelection answer;
  const auto closed = [&] { return search.best().cost_m - search.lower_bound_m() <= gap_m; };
  for (; !closed() && answer.nodes < settings.most_nodes; ++answer.nodes) search.split();
  answer.best = search.best();
  answer.lower_bound_m = search.lower_bound_m();
  answer.certified = closed();
  return answer;
}

}  // namespace honka
