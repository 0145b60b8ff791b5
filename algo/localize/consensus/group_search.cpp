#include "algo/localize/consensus/group_search.h"

#include <algorithm>
#include <array>
#include <utility>

#include "algo/localize/consensus/twins.h"

namespace honka {
namespace {

constexpr std::size_t kLocalNear = 6;
constexpr std::size_t kWitnesses = 16;        // stems around a group that are heard first
constexpr std::size_t kRefinedPerGroup = 32;  // the rest of a lattice's look-alikes are not needed
constexpr double kDoubtless_nats = 10.0;      // beyond acceptance
constexpr int kGroupsAfterwards = 3;          // a copy elsewhere shares most of its groups
constexpr int kGroupsAmongAlike = 40;         // how alike a pattern's places are takes many of them
constexpr int kGroupsOfPattern = 100;         // a frame of the map is found by far fewer
constexpr std::size_t kHeardOfPattern = 1'000'000;  // a second; a grid without jitter fits anywhere

using ThreeOf = std::array<std::uint8_t, 3>;

/// Three of six neighbours, by the farthest: those that survive missed stems
/// best come first.
constexpr std::array<ThreeOf, 20> kThreeOfSix = [] {
  std::array<ThreeOf, 20> all{};
  std::size_t next = 0;
  for (std::uint8_t c = 2; c < kLocalNear; ++c) {
    for (std::uint8_t b = 1; b < c; ++b) {
      for (std::uint8_t a = 0; a < b; ++a) all[next++] = {a, b, c};
    }
  }
  return all;
}();

/// One search: its buffers and what it has seen.
class GroupSearch {
 public:
  GroupSearch(const Judge& judge, const LocalFrame& frame, const Allowed& allows, PlaceList& places)
      : judge_(judge),
        frame_(frame),
        allows_(allows),
        places_(places),
        near_(frame.stems_m.size()) {}

  std::int64_t run() {
    for (const ThreeOf& three : kThreeOfSix) {
      for (std::uint32_t base = 0; base < frame_.stems_m.size(); ++base) {
        try_group(base, three);
        if (is_beyond_doubt() && ++afterwards_ > groups_afterwards()) return tried_;
        if (is_alike_for_long()) return tried_;
      }
    }
    return tried_;
  }

 private:
  const std::vector<std::uint32_t>& near(std::uint32_t base) {
    if (near_[base].empty()) frame_.nearest(base, kWitnesses, near_[base]);
    return near_[base];
  }

  /// Looks one local group up, hears all that fits, refines the best of it.
  void try_group(std::uint32_t base, const ThreeOf& three) {
    const auto& around = near(base);
    if (three[2] >= around.size()) return;
    std::array<std::uint32_t, 3> others{around[three[0]], around[three[1]], around[three[2]]};
    sort_around(frame_.stems_m, base, others);
    const double tolerance = 3.0 * judge_.settings().stem_sigma_m;
    heard_.clear();
    for (std::size_t turn = 0; turn < 3; ++turn) {
      const StemGroup g = turned({base, others[0], others[1], others[2]}, turn);
      const GroupShape shape = shape_of(frame_.stems_m, g);
      // The map's groups start with their longest leg; noise may have made it
      // the second here.
      if (shape.legs_m[0] + tolerance < std::max(shape.legs_m[1], shape.legs_m[2])) continue;
      judge_.index().groups().find(shape, tolerance, found_);
      if (!allows_.everywhere()) keep_allowed(base);
      hear_found(g);
    }
    heard_since_better_ += heard_.size();
    refine_heard();
  }

  /// Of the map groups found, those whose first stem the prior leaves to the local one.
  void keep_allowed(std::uint32_t base) {
    constexpr double kSlack_m = 2.0;  // of a group of four fitted to three s.d., and its turn
    const auto& stems = judge_.index().grid().stems();
    std::erase_if(found_, [&](std::uint32_t id) {
      return !allows_.may_pair(frame_.stems_m[base], stems[GroupTable::first_stem(id)], kSlack_m);
    });
  }

  void hear_found(const StemGroup& local) {
    constexpr std::size_t kRowsAhead = 16;
    constexpr std::size_t kStemsAhead = 8;
    const GroupTable& groups = judge_.index().groups();
    const StemGrid& grid = judge_.index().grid();
    for (std::size_t k = 0; k < found_.size(); ++k) {
      if (k + kRowsAhead < found_.size()) groups.fetch_row(grid, found_[k + kRowsAhead]);
      if (k + kStemsAhead < found_.size()) groups.fetch_stems(grid, found_[k + kStemsAhead]);
      hear_pairing(local, found_[k]);
    }
  }

  void hear_pairing(const StemGroup& local, std::uint32_t id) {
    const StemGrid& grid = judge_.index().grid();
    const StemGroup map = judge_.index().groups().group(grid, id);
    const Eigen::Vector2d origin = grid.stems()[map[0]];
    PairSums sums;
    for (std::size_t k = 0; k < 4; ++k) {
      sums.add(frame_.stems_m[local[k]], grid.stems()[map[k]] - origin, 1.0);
    }
    ++tried_;
    Fit fit = solve(sums, origin);
    fit.sigma_m = judge_.settings().stem_sigma_m;
    // Five degrees of freedom are left: a true group exceeds 18 σ² once in 300.
    if (fit.squares_m2 > 18.0 * fit.sigma_m * fit.sigma_m || !allows_(fit.placement)) return;
    const auto nats = judge_.hear(fit, near(local[0]));
    if (!nats) return;
    fit.evidence_nats = *nats;
    heard_.push_back(fit);
  }

  void refine_heard() {
    const std::size_t kept = std::min(heard_.size(), kRefinedPerGroup);
    std::partial_sort(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(kept),
                      heard_.end(),
                      [](const Fit& a, const Fit& b) { return a.evidence_nats > b.evidence_nats; });
    for (std::size_t k = 0; k < kept; ++k) {
      if (!places_.knows(heard_[k].placement)) places_.add(judge_.refine(heard_[k]));
    }
  }

  /// Whether the best place is far above chance and above all others, its own
  /// twins among them.
  bool is_beyond_doubt() {
    const double accept = judge_.settings().accept_nats;
    const auto holds = [&] {
      const Fit* best = places_.best();
      return best != nullptr && best->evidence_nats > accept + kDoubtless_nats &&
             places_.margin_nats(accept) > accept;
    };
    if (!holds()) return false;
    const Fit best = *places_.best();
    if (best.evidence_nats != twins_of_nats_) {
      add_twins(judge_, best, allows_, places_);
      twins_of_nats_ = best.evidence_nats;
    }
    return holds();
  }

  /// Groups that are tried after a place is beyond doubt: where chance does better than it does in
  /// a forest, rivals of the same pattern are yet unknown.
  [[nodiscard]] int groups_afterwards() const {
    constexpr double kMoreThanChance_nats = 5.0;
    return places_.rivals(kMoreThanChance_nats) > 0 ? kGroupsAmongAlike : kGroupsAfterwards;
  }

  /// Whether places beyond chance look alike and none has come out on top for many groups, as in
  /// the wrong rows of a plantation: what is left to try shows more of the same.
  bool is_alike_for_long() {
    constexpr double kBetter_nats = 1.0;
    const double accept = judge_.settings().accept_nats;
    const Fit* best = places_.best();
    if (best == nullptr || best->evidence_nats < accept) return false;
    if (best->evidence_nats > best_nats_ + kBetter_nats) {
      best_nats_ = best->evidence_nats;
      groups_since_better_ = 0;
      heard_since_better_ = 0;
    }
    const bool long_ago =
        ++groups_since_better_ > kGroupsOfPattern || heard_since_better_ > kHeardOfPattern;
    return long_ago && places_.margin_nats(accept) < accept;
  }

  const Judge& judge_;
  const LocalFrame& frame_;
  const Allowed& allows_;
  PlaceList& places_;
  std::vector<std::vector<std::uint32_t>> near_;
  std::vector<std::uint32_t> found_;
  std::vector<Fit> heard_;
  double twins_of_nats_ = 0.0;
  int afterwards_ = 0;
  double best_nats_ = 0.0;
  int groups_since_better_ = 0;
  std::size_t heard_since_better_ = 0;
  std::int64_t tried_ = 0;
};

}  // namespace

std::int64_t search_groups(const Judge& judge, const LocalFrame& frame, const Allowed& allows,
                           PlaceList& places) {
  return GroupSearch(judge, frame, allows, places).run();
}

}  // namespace honka
