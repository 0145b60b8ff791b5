#include "algo/localize/consensus/group_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "algo/types/large_pages.h"
#include "algo/types/random.h"

namespace honka {
namespace {

constexpr double kReach_m = 30.0;  // neighbours farther apart are never seen in one frame
constexpr std::size_t kCombinations = GroupTable::kCombinations;

using Combination = std::array<std::uint8_t, 3>;

/// Three of seven, rising.
constexpr std::array<Combination, kCombinations> kThreeOfSeven = [] {
  std::array<Combination, kCombinations> all{};
  std::size_t next = 0;
  for (std::uint8_t a = 0; a < 7; ++a) {
    for (std::uint8_t b = a + 1; b < 7; ++b) {
      for (std::uint8_t c = b + 1; c < 7; ++c) all[next++] = {a, b, c};
    }
  }
  return all;
}();

constexpr std::size_t kBatch = 64;  // groups whose places in the table are looked up together
constexpr double kBin_m = 0.5;
constexpr std::uint64_t kSideBySide = 8;  // bins of the last distance that one hash covers

using Bins = std::array<std::uint64_t, 5>;

std::uint64_t bin_of(double distance_m) {
  return static_cast<std::uint64_t>(std::max(distance_m, 0.0) * (1.0 / kBin_m));
}

Bins bins_of(const GroupShape& s, double shift_m) {
  return {bin_of(s.legs_m[0] + shift_m), bin_of(s.legs_m[1] + shift_m),
          bin_of(s.legs_m[2] + shift_m), bin_of(s.sides_m[0] + shift_m),
          bin_of(s.sides_m[1] + shift_m)};
}

/// Of the first four distances, eight bits each: sixteenths of a metre, whole
/// 16 m left out.
std::uint32_t fingerprint(const GroupShape& s, double shift_m) {
  std::uint32_t print = 0;
  for (const double d : {s.legs_m[0], s.legs_m[1], s.legs_m[2], s.sides_m[0]}) {
    print = print << 8U | (static_cast<std::uint32_t>(std::max(d + shift_m, 0.0) * 16.0) & 255U);
  }
  return print;
}

/// Whether each of four bytes lies in its range, which may wrap around.
bool is_within(std::uint32_t print, std::uint32_t low, std::uint32_t high) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const auto above = static_cast<std::uint8_t>((print >> shift) - (low >> shift));
    if (above > static_cast<std::uint8_t>((high >> shift) - (low >> shift))) return false;
  }
  return true;
}

/// Which of three legs is the longest, the first of equals.
std::size_t longest_of(double a, double b, double c) {
  if (a >= b && a >= c) return 0;
  return b >= c ? 1 : 2;
}

/// A stem with its neighbours: all distances that its groups need.
struct Surroundings {
  std::array<double, 7> legs_m{};
  std::array<std::array<double, 7>, 7> sides_m{};

  Surroundings(const StemGrid& grid, std::uint32_t base, const GroupTable::NearStems& near,
               std::size_t count) {
    for (std::size_t a = 0; a < count; ++a) {
      const Eigen::Vector2d& p = grid.stems()[near[a]];
      legs_m[a] = (p - grid.stems()[base]).norm();
      for (std::size_t b = 0; b < a; ++b) {
        sides_m[a][b] = sides_m[b][a] = (p - grid.stems()[near[b]]).norm();
      }
    }
  }

  [[nodiscard]] GroupShape shape(const Combination& c) const {
    const std::size_t first = longest_of(legs_m[c[0]], legs_m[c[1]], legs_m[c[2]]);
    const std::size_t i = c[first];
    const std::size_t j = c[(first + 1) % 3];
    const std::size_t k = c[(first + 2) % 3];
    return {{legs_m[i], legs_m[j], legs_m[k]}, {sides_m[i][j], sides_m[j][k]}};
  }
};

}  // namespace

GroupTable::GroupTable(const StemGrid& grid) {
  find_neighbours(grid);
  sort_groups(grid);
}

void GroupTable::find_neighbours(const StemGrid& grid) {
  const std::size_t n = grid.stems().size();
  NearStems none;
  none.fill(kNone);
  near_.assign(n, none);
  densities_per_m2_.assign(n, static_cast<float>(grid.density_per_m2()));
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < n; ++i) {
    grid.nearest_others(i, kNear, kReach_m, found);
    for (std::size_t k = 0; k < found.size(); ++k) near_[i][k] = found[k].second;
    sort_around(grid.stems(), i, std::span(near_[i]).first(found.size()));
    if (found.size() < kNear) continue;
    const double around = kNear / (std::numbers::pi * found.back().first);
    densities_per_m2_[i] = std::max(densities_per_m2_[i], static_cast<float>(around));
  }
}

StemGroup GroupTable::group(const StemGrid& grid, std::uint32_t id) const {
  const std::uint32_t base = id / kCombinations;
  const Combination& c = kThreeOfSeven[id % kCombinations];
  const StemGroup g{base, near_[base][c[0]], near_[base][c[1]], near_[base][c[2]]};
  const auto leg = [&](std::size_t k) { return (grid.stems()[g[k]] - grid.stems()[base]).norm(); };
  return turned(g, longest_of(leg(1), leg(2), leg(3)));
}

std::size_t GroupTable::bucket_of(const Bins& bins) const {
  std::uint64_t key = bins[4] / kSideBySide;
  for (std::size_t k = 0; k < 4; ++k) key = key << 10U | (bins[k] & 1023U);
  return (mix64(key) * kSideBySide + bins[4] % kSideBySide) & bucket_mask_;
}

template <class F>
void GroupTable::for_each_group(const StemGrid& grid, F&& f) const {
  for (std::uint32_t i = 0; i < near_.size(); ++i) {
    const auto end = std::find(near_[i].begin(), near_[i].end(), kNone);
    const auto count = static_cast<std::size_t>(end - near_[i].begin());
    const Surroundings around(grid, i, near_[i], count);
    for (std::size_t c = 0; c < kCombinations; ++c) {
      if (kThreeOfSeven[c][2] >= count) continue;
      f(static_cast<std::uint32_t>(i * kCombinations + c), around.shape(kThreeOfSeven[c]));
    }
  }
}

void GroupTable::sort_groups(const StemGrid& grid) {
  bucket_mask_ = std::bit_ceil(std::max(near_.size() * kCombinations, kSideBySide)) - 1;
  reserve_in_large_pages(starts_, bucket_mask_ + 2);
  starts_.assign(bucket_mask_ + 2, 0);
  // The buckets of a batch are asked of the memory together: single ones would be waited for.
  std::vector<Sorted> batch;
  const auto in_batches = [&](auto&& flush) {
    for_each_group(grid, [&](std::uint32_t id, const GroupShape& shape) {
      batch.push_back({bucket_of(bins_of(shape, 0.0)), {id, fingerprint(shape, 0.0)}});
      __builtin_prefetch(&starts_[batch.back().place], 1);
      if (batch.size() < kBatch) return;
      flush();
      batch.clear();
    });
    flush();
    batch.clear();
  };
  in_batches([&] {
    for (const Sorted& one : batch) ++starts_[one.place];
  });
  for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
  // Each start moves from the end of its bucket to the front while that is filled.
  reserve_in_large_pages(entries_, starts_.back());
  entries_.resize(starts_.back());
  in_batches([&] {
    for (Sorted& one : batch) {
      one.place = --starts_[one.place];
      __builtin_prefetch(&entries_[one.place], 1);
    }
    for (const Sorted& one : batch) entries_[one.place] = one.entry;
  });
}

void GroupTable::find(const GroupShape& shape, double tolerance_m,
                      std::vector<std::uint32_t>& found) const {
  found.clear();
  const Bins low = bins_of(shape, -tolerance_m);
  const Bins high = bins_of(shape, tolerance_m);
  const std::uint32_t least = fingerprint(shape, -tolerance_m);
  const std::uint32_t most = fingerprint(shape, tolerance_m);
  Bins b = low;
  const auto collect = [&] {
    for (b[4] = low[4]; b[4] <= high[4]; ++b[4]) {
      const std::size_t bucket = bucket_of(b);
      for (std::uint32_t e = starts_[bucket]; e < starts_[bucket + 1]; ++e) {
        if (is_within(entries_[e].fingerprint, least, most)) found.push_back(entries_[e].group);
      }
    }
  };
  for (b[0] = low[0]; b[0] <= high[0]; ++b[0]) {
    for (b[1] = low[1]; b[1] <= std::min(high[1], b[0]); ++b[1]) {
      for (b[2] = low[2]; b[2] <= std::min(high[2], b[0]); ++b[2]) {
        for (b[3] = low[3]; b[3] <= std::min(high[3], b[0] + b[1] + 1); ++b[3]) collect();
      }
    }
  }
}

void GroupTable::write(ByteWriter& out) const {
  out.value(static_cast<std::uint64_t>(bucket_mask_));
  out.list(near_);
  out.list(densities_per_m2_);
  out.list(starts_);
  out.list(entries_);
}

GroupTable GroupTable::read(ByteReader& in) {
  GroupTable table;
  table.bucket_mask_ = in.value<std::uint64_t>();
  table.near_ = in.list<NearStems>();
  table.densities_per_m2_ = in.list<float>();
  table.starts_ = in.list<std::uint32_t>();
  table.entries_ = in.list<Entry>();
  return table;
}

bool GroupTable::belongs_to(const StemGrid& grid) const {
  const std::size_t n = grid.stems().size();
  const auto names_stems = [&](const NearStems& near) {
    return std::all_of(near.begin(), near.end(),
                       [&](std::uint32_t i) { return i < n || i == kNone; });
  };
  const auto names_group = [&](const Entry& e) {
    const std::size_t base = e.group / kCombinations;
    return base < n && near_[base][kThreeOfSeven[e.group % kCombinations][2]] != kNone;
  };
  return near_.size() == n && densities_per_m2_.size() == n &&
         std::has_single_bit(bucket_mask_ + 1) && starts_.size() == bucket_mask_ + 2 &&
         starts_.back() == entries_.size() && std::is_sorted(starts_.begin(), starts_.end()) &&
         std::all_of(near_.begin(), near_.end(), names_stems) &&
         std::all_of(entries_.begin(), entries_.end(), names_group);
}

}  // namespace honka
