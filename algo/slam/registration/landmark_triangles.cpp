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
constexpr double kVoteTurn_deg = 3.0;
constexpr double kVoteShift_m = 1.0;

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

/// The place of a vote in a table of places.
struct VotePlace {
  std::int64_t turn = 0, x = 0, y = 0;
  bool operator==(const VotePlace&) const = default;
};

constexpr std::int64_t kVoteTurns = static_cast<std::int64_t>(360.0 / kVoteTurn_deg);

VotePlace place_of(const TriangleVote& vote) {
  const double turn = (vote.yaw_rad + std::numbers::pi) / (2.0 * std::numbers::pi);
  return {std::min(static_cast<std::int64_t>(turn * kVoteTurns), kVoteTurns - 1),
          static_cast<std::int64_t>(std::floor(vote.shift_m.x() / kVoteShift_m)),
          static_cast<std::int64_t>(std::floor(vote.shift_m.y() / kVoteShift_m))};
}

/// Places with their votes: a hash table of fixed size with open addresses.
class VoteTable {
 public:
  explicit VoteTable(std::size_t votes) {
    std::size_t size = 64;
    while (size < 2 * votes) size *= 2;
    slots_.assign(size, kFree);
  }

  struct Entry {
    VotePlace place;
    int votes = 0;
    double sine = 0.0, cosine = 0.0;
    Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
  };

  void add(const TriangleVote& vote) {
    const VotePlace place = place_of(vote);
    std::uint32_t& slot = slots_[slot_of(place)];
    if (slot == kFree) {
      slot = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({.place = place});
    }
    Entry& entry = entries_[slot];
    ++entry.votes;
    entry.sine += vote.sine;
    entry.cosine += vote.cosine;
    entry.shift_m += vote.shift_m;
  }

  [[nodiscard]] const Entry* find(const VotePlace& place) const {
    const std::uint32_t slot = slots_[slot_of(place)];
    return slot == kFree ? nullptr : &entries_[slot];
  }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;

  [[nodiscard]] std::size_t slot_of(const VotePlace& place) const {
    const auto hash = static_cast<std::uint64_t>(place.turn) * 0x9e3779b97f4a7c15ULL +
                      static_cast<std::uint64_t>(place.x) * 0xc2b2ae3d27d4eb4fULL +
                      static_cast<std::uint64_t>(place.y) * 0x165667b19e3779f9ULL;
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (hash ^ (hash >> 29U)) & mask;
    while (slots_[slot] != kFree && !(entries_[slots_[slot]].place == place)) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Entry> entries_;
};

/// A place with the votes of those around it.
VoteTable::Entry with_neighbours(const VoteTable& table, const VotePlace& place) {
  VoteTable::Entry sum{.place = place};
  for (std::int64_t k = 0; k < 27; ++k) {
    const std::int64_t turn = (place.turn + k / 9 - 1 + kVoteTurns) % kVoteTurns;
    const auto* entry = table.find({turn, place.x + k / 3 % 3 - 1, place.y + k % 3 - 1});
    if (entry == nullptr) continue;
    sum.votes += entry->votes;
    sum.sine += entry->sine;
    sum.cosine += entry->cosine;
    sum.shift_m += entry->shift_m;
  }
  return sum;
}

bool are_neighbours(const VotePlace& a, const VotePlace& b) {
  const std::int64_t turn = std::abs(a.turn - b.turn);
  return std::min(turn, kVoteTurns - turn) <= 1 && std::abs(a.x - b.x) <= 1 &&
         std::abs(a.y - b.y) <= 1;
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

std::vector<Pose2> most_voted(std::span<const TriangleVote> votes, std::size_t count) {
  VoteTable table(votes.size());
  for (const TriangleVote& vote : votes) table.add(vote);
  // The places that a true one must be among, before their neighbours are counted too.
  constexpr std::size_t kPlacesPerCandidate = 8;
  std::vector<std::uint32_t> order(table.entries().size());
  std::iota(order.begin(), order.end(), 0U);
  const auto& entries = table.entries();
  const auto kept = std::min(order.size(), kPlacesPerCandidate * count);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                    [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(-entries[a].votes, a) < std::pair(-entries[b].votes, b);
                    });
  std::vector<VoteTable::Entry> sums;
  for (std::size_t k = 0; k < kept; ++k) {
    sums.push_back(with_neighbours(table, entries[order[k]].place));
  }
  std::stable_sort(sums.begin(), sums.end(),
                   [](const auto& a, const auto& b) { return a.votes > b.votes; });
  std::vector<Pose2> best;
  std::vector<VotePlace> taken;
  for (const VoteTable::Entry& sum : sums) {
    if (best.size() == count) break;
    const auto beside = [&](const VotePlace& place) { return are_neighbours(place, sum.place); };
    if (std::any_of(taken.begin(), taken.end(), beside)) continue;
    taken.push_back(sum.place);
    best.push_back({sum.shift_m / sum.votes, std::atan2(sum.sine, sum.cosine)});
  }
  return best;
}

}  // namespace honka
