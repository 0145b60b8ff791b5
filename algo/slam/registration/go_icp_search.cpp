#include "algo/slam/registration/go_icp_search.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <queue>

namespace honka {
namespace {

using SearchClock = std::chrono::steady_clock;

struct SearchNode {
  double lower_m = 0.0;
  std::int64_t number = 0;  ///< in order of making: equal bounds, equal order everywhere
  MotionBox box;
};

struct LaterNode {
  bool operator()(const SearchNode& a, const SearchNode& b) const {
    return a.lower_m != b.lower_m ? a.lower_m > b.lower_m : a.number < b.number;
  }
};

/// The widest of the three half widths, in metres that points move by: 0 x, 1 y, 2 yaw.
int widest_dimension(const MotionBox& box, double lever_m) {
  const std::array<double, 3> widths = {box.half_shift_m.x(), box.half_shift_m.y(),
                                        box.half_yaw_rad * lever_m};
  return static_cast<int>(std::max_element(widths.begin(), widths.end()) - widths.begin());
}

std::array<MotionBox, 2> cut(const MotionBox& box, int dimension) {
  std::array<MotionBox, 2> halves = {box, box};
  if (dimension == 2) {
    const double half = 0.5 * box.half_yaw_rad;
    for (MotionBox& b : halves) b.half_yaw_rad = half;
    halves[0].middle.yaw_rad -= half;
    halves[1].middle.yaw_rad += half;
  } else {
    const double half = 0.5 * box.half_shift_m[dimension];
    for (MotionBox& b : halves) b.half_shift_m[dimension] = half;
    halves[0].middle.shift_m[dimension] -= half;
    halves[1].middle.shift_m[dimension] += half;
  }
  return halves;
}

/// One search: the boxes yet to visit, the best motion, and what is known of the boxes dropped.
class BoxSearch {
 public:
  BoxSearch(TrimmedObjective& objective, const SearchLimits& limits, const PlanarMotion& start)
      : objective_(objective), limits_(limits) {
    result_.best = objective_.polish(start);
    result_.best_m = objective_.rmse(result_.best);
  }

  void visit(const MotionBox& box) {
    ++result_.nodes;
    const double enough_m = std::max(result_.best_m - limits_.gap_m, 0.0);
    const auto bound = objective_.bound(box, result_.best_m, enough_m);
    if (bound.middle_m < result_.best_m) improve(box.middle);
    if (bound.lower_m >= enough_m) {
      dropped_m_ = std::min(dropped_m_, bound.lower_m);
    } else if (is_leaf(box)) {
      dropped_m_ = std::min(dropped_m_, bound.lower_m);
      improve(box.middle);
    } else {
      open_.push({bound.lower_m, result_.nodes, box});
    }
  }

  [[nodiscard]] bool is_done() const {
    return open_.empty() || open_.top().lower_m >= result_.best_m - limits_.gap_m;
  }

  [[nodiscard]] bool is_capped() {
    const auto reached = [&] {
      if (limits_.node_cap > 0 && result_.nodes >= limits_.node_cap) return true;
      constexpr std::int64_t kNodesBetweenLooks = 64;
      if (limits_.time_cap_s <= 0.0 || ++looks_ % kNodesBetweenLooks != 0) return false;
      return std::chrono::duration<double>(SearchClock::now() - began_).count() >=
             limits_.time_cap_s;
    };
    if (!result_.capped) result_.capped = reached();
    return result_.capped;
  }

  void visit_halves_of_next() {
    const MotionBox box = open_.top().box;
    open_.pop();
    for (const MotionBox& half : cut(box, widest_dimension(box, objective_.lever_m()))) {
      visit(half);
    }
  }

  [[nodiscard]] SearchResult finish() const {
    SearchResult result = result_;
    result.icp_steps = objective_.icp_steps();
    result.lower_m = std::min(dropped_m_, result.best_m);
    if (!open_.empty()) result.lower_m = std::min(result.lower_m, open_.top().lower_m);
    return result;
  }

 private:
  [[nodiscard]] bool is_leaf(const MotionBox& box) const {
    return (box.half_shift_m.array() <= limits_.leaf.half_shift_m.array()).all() &&
           box.half_yaw_rad <= limits_.leaf.half_yaw_rad;
  }

  void improve(const PlanarMotion& from) {
    ++result_.polishes;
    const PlanarMotion polished = objective_.polish(from);
    const double error = objective_.rmse(polished);
    if (error < result_.best_m) {
      result_.best = polished;
      result_.best_m = error;
    }
  }

  TrimmedObjective& objective_;
  const SearchLimits& limits_;
  SearchResult result_;
  std::priority_queue<SearchNode, std::vector<SearchNode>, LaterNode> open_;
  double dropped_m_ = std::numeric_limits<double>::infinity();
  SearchClock::time_point began_ = SearchClock::now();
  std::int64_t looks_ = 0;
};

}  // namespace

SearchResult branch_and_bound(TrimmedObjective& objective, const std::vector<MotionBox>& region,
                              const PlanarMotion& start, const SearchLimits& limits) {
  BoxSearch search(objective, limits, start);
  for (const MotionBox& box : region) search.visit(box);
  while (!search.is_done() && !search.is_capped()) search.visit_halves_of_next();
  return search.finish();
}

}  // namespace honka
