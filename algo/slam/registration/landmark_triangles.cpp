#include "algo/slam/registration/landmark_triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "algo/types/check.h"

namespace honka {
namespace {

constexpr double kShortestTriangleSide_m = 0.5;  // two points of one stem or of one bush
constexpr int kMostAlike = 400;                  // target triangles one source triangle votes for

using NearList = std::vector<std::uint32_t>;

/// The points nearest to one, at most so many, rising by distance and index.
class NearestOthers {
 public:
  explicit NearestOthers(std::size_t count) : count_(count) {}

  void offer(double squared_m2, std::uint32_t index) {
    if (squared_m2 < kLeast_m2) return;
    const std::pair entry(squared_m2, index);
    if (nearest_.size() == count_) {
      if (nearest_.back() <= entry) return;
      nearest_.pop_back();
    }
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), entry), entry);
  }
  /// Whether a point so far away along x alone, and all beyond it, is too far.
  [[nodiscard]] bool are_nearer_than(double along_x_m) const {
    return nearest_.size() == count_ && along_x_m * along_x_m > nearest_.back().first;
  }
  /// In order of index; empty afterwards.
  [[nodiscard]] NearList take() {
    NearList list;
    for (const auto& [squared, j] : nearest_) list.push_back(j);
    std::sort(list.begin(), list.end());
    nearest_.clear();
    return list;
  }

 private:
  static constexpr double kLeast_m2 = kShortestTriangleSide_m * kShortestTriangleSide_m;
  std::size_t count_;
  std::vector<std::pair<double, std::uint32_t>> nearest_;
};

/// Of each point, the nearest others, in order of index. A sweep along x: few points are looked at.
std::vector<NearList> nearest_others(std::span<const Eigen::Vector2d> points, std::size_t count) {
  std::vector<std::uint32_t> by_x(points.size());
  std::iota(by_x.begin(), by_x.end(), 0U);
  std::sort(by_x.begin(), by_x.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : a < b;
  });
  std::vector<NearList> near(points.size());
  NearestOthers nearest(count);
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Eigen::Vector2d place = points[by_x[i]];
    const auto is_offered = [&](std::uint32_t j) {
      const Eigen::Vector2d away = points[j] - place;
      if (nearest.are_nearer_than(away.x())) return false;
      nearest.offer(away.squaredNorm(), j);
      return true;
    };
    std::size_t left = i;
    std::size_t right = i + 1;
    bool leftwards = true;
    bool rightwards = true;
    while (leftwards || rightwards) {
      leftwards = leftwards && left > 0 && is_offered(by_x[--left]);
      rightwards = rightwards && right < by_x.size() && is_offered(by_x[right++]);
    }
    near[by_x[i]] = nearest.take();
  }
  return near;
}

bool lists_both(const NearList& list, std::uint32_t a, std::uint32_t b) {
  return std::find(list.begin(), list.end(), a) != list.end() &&
         std::find(list.begin(), list.end(), b) != list.end();
}

LandmarkTriangle make_triangle(std::span<const Eigen::Vector2d> points,
                               const std::array<std::uint32_t, 3>& corners) {
  std::array<std::pair<double, std::uint32_t>, 3> by_side;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (points[corners[(k + 1) % 3]] - points[corners[(k + 2) % 3]]).norm();
    by_side[k] = {side, corners[k]};
  }
  std::sort(by_side.begin(), by_side.end(), std::greater<>());
  LandmarkTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.sides_m[k] = by_side[k].first;
    triangle.corners[k] = by_side[k].second;
  }
  const Eigen::Vector2d a = points[triangle.corners[1]] - points[triangle.corners[0]];
  const Eigen::Vector2d b = points[triangle.corners[2]] - points[triangle.corners[0]];
  triangle.is_counter_clockwise = a.x() * b.y() - a.y() * b.x() > 0.0;
  return triangle;
}

/// What lists of triangles are sorted by.
std::pair<bool, double> turn_and_longest(const LandmarkTriangle& triangle) {
  return {triangle.is_counter_clockwise, triangle.sides_m[0]};
}

/// Of triangles whose turn and longest side agree already.
bool are_alike(const LandmarkTriangle& a, const LandmarkTriangle& b, double tolerance_m) {
  return std::abs(a.sides_m[1] - b.sides_m[1]) <= tolerance_m &&
         std::abs(a.sides_m[2] - b.sides_m[2]) <= tolerance_m;
}

/// Least squares over the three corners.
TriangleVote vote_of(std::span<const Eigen::Vector2d> target_m, const LandmarkTriangle& t,
                     std::span<const Eigen::Vector2d> source_m, const LandmarkTriangle& s) {
  std::array<Eigen::Vector2d, 3> to, from;
  for (std::size_t c = 0; c < 3; ++c) {
    to[c] = target_m[t.corners[c]];
    from[c] = source_m[s.corners[c]];
  }
  const Eigen::Vector2d to_middle = (to[0] + to[1] + to[2]) / 3.0;
  const Eigen::Vector2d from_middle = (from[0] + from[1] + from[2]) / 3.0;
  double dot = 0.0;
  double cross = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::Vector2d p = from[c] - from_middle;
    const Eigen::Vector2d q = to[c] - to_middle;
    dot += p.x() * q.x() + p.y() * q.y();
    cross += p.x() * q.y() - p.y() * q.x();
  }
  TriangleVote vote;
  const double length = std::sqrt(dot * dot + cross * cross);
  if (length > 0.0) {
    vote.cosine = dot / length;
    vote.sine = cross / length;
  }
  vote.yaw_rad = std::atan2(vote.sine, vote.cosine);
  vote.shift_m.x() = to_middle.x() - (vote.cosine * from_middle.x() - vote.sine * from_middle.y());
  vote.shift_m.y() = to_middle.y() - (vote.sine * from_middle.x() + vote.cosine * from_middle.y());
  return vote;
}

}  // namespace

std::vector<LandmarkTriangle> landmark_triangles(std::span<const Eigen::Vector2d> points_m,
                                                 std::int64_t neighbours) {
  const auto near = nearest_others(points_m, static_cast<std::size_t>(neighbours));
  std::vector<LandmarkTriangle> triangles;
  for (std::uint32_t i = 0; i < points_m.size(); ++i) {
    for (std::size_t a = 0; a < near[i].size(); ++a) {
      for (std::size_t b = a + 1; b < near[i].size(); ++b) {
        const std::uint32_t j = near[i][a];
        const std::uint32_t k = near[i][b];
        // The corner of the lowest index that lists the other two has it.
        if (j < i && lists_both(near[j], i, k)) continue;
        if (k < i && lists_both(near[k], i, j)) continue;
        const LandmarkTriangle triangle = make_triangle(points_m, {i, j, k});
        if (triangle.sides_m[2] >= kShortestTriangleSide_m) triangles.push_back(triangle);
      }
    }
  }
  std::sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
    return std::tie(a.is_counter_clockwise, a.sides_m, a.corners) <
           std::tie(b.is_counter_clockwise, b.sides_m, b.corners);
  });
  return triangles;
}

Pose2 fit_planar(std::span<const Eigen::Vector2d> target_m,
                 std::span<const Eigen::Vector2d> source_m) {
  HONKA_CHECK(!source_m.empty() && source_m.size() == target_m.size(), "pairs to be fitted");
  const double n = static_cast<double>(source_m.size());
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < source_m.size(); ++i) {
    from += source_m[i] / n;
    to += target_m[i] / n;
  }
  double dot = 0.0;
  double cross = 0.0;
  for (std::size_t i = 0; i < source_m.size(); ++i) {
    const Eigen::Vector2d p = source_m[i] - from;
    const Eigen::Vector2d q = target_m[i] - to;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
  }
  Pose2 fit;
  fit.yaw_rad = std::atan2(cross, dot);
  fit.translation_m = to - Eigen::Rotation2Dd(fit.yaw_rad) * from;
  return fit;
}

std::vector<TriangleVote> triangle_votes(std::span<const Eigen::Vector2d> target_m,
                                         std::span<const LandmarkTriangle> of_target,
                                         std::span<const Eigen::Vector2d> source_m,
                                         std::span<const LandmarkTriangle> of_source,
                                         double tolerance_m) {
  std::vector<TriangleVote> votes;
  std::size_t begin = 0;
  for (const LandmarkTriangle& s : of_source) {
    const auto shortest = std::pair(s.is_counter_clockwise, s.sides_m[0] - tolerance_m);
    const auto longest = std::pair(s.is_counter_clockwise, s.sides_m[0] + tolerance_m);
    while (begin < of_target.size() && turn_and_longest(of_target[begin]) < shortest) ++begin;
    int alike = 0;
    for (std::size_t k = begin; k < of_target.size() && alike < kMostAlike; ++k) {
      const LandmarkTriangle& t = of_target[k];
      if (turn_and_longest(t) > longest) break;
      if (!are_alike(s, t, tolerance_m)) continue;
      ++alike;
      votes.push_back(vote_of(target_m, t, source_m, s));
    }
  }
  return votes;
}

}  // namespace honka
