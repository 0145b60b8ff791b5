#include "algo/slam/registration/vote_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace honka {
namespace {

constexpr double kVoteTurn_deg = 3.0;
constexpr double kVoteShift_m = 1.0;

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
