#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "algo/localize/consensus/bytes.h"
#include "algo/localize/consensus/group.h"
#include "algo/localize/consensus/stem_grid.h"

namespace honka {

/// Groups of a map's stems, found by their shape: each stem with three of its
/// seven nearest.
///
/// A counting sort by hashed bins of the five distances: eight bytes a group,
/// 35 groups a stem. Bins of the last distance lie side by side, so that a
/// search walks through memory.
class GroupTable {
 public:
  static constexpr std::size_t kNear = 7;  ///< of 30 % missed stems, three of five still have these
  static constexpr std::size_t kCombinations = 35;  ///< three of seven
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using NearStems = std::array<std::uint32_t, kNear>;  ///< counter-clockwise; kNone at the end

  GroupTable() = default;
  explicit GroupTable(const StemGrid& grid);

  void write(ByteWriter& out) const;
  /// Throws UserError where the bytes end too early.
  [[nodiscard]] static GroupTable read(ByteReader& in);
  /// Whether every number in the table names a stem of the grid or a place in
  /// the table.
  [[nodiscard]] bool belongs_to(const StemGrid& grid) const;

  /// Ids of groups whose five distances may all be within the tolerance; and
  /// some others.
  void find(const GroupShape& shape, double tolerance_m, std::vector<std::uint32_t>& found) const;
  /// Asks the memory for what `group` needs of an id: first its row, then (when that has come) its
  /// stems. Of a large map neither is in the cache, and single requests are waited for.
  void fetch_row(const StemGrid& grid, std::uint32_t id) const {
    __builtin_prefetch(&near_[id / kCombinations]);
    __builtin_prefetch(&grid.stems()[id / kCombinations]);
  }
  void fetch_stems(const StemGrid& grid, std::uint32_t id) const {
    for (const std::uint32_t stem : near_[id / kCombinations]) {
      if (stem != kNone) __builtin_prefetch(&grid.stems()[stem]);
    }
  }
  /// The group of an id, from its longest leg on.
  /// Of a group, as index of the grid.
  [[nodiscard]] static std::uint32_t first_stem(std::uint32_t id) { return id / kCombinations; }
  [[nodiscard]] StemGroup group(const StemGrid& grid, std::uint32_t id) const;
  /// Stems per m² around a stem, at least those of the whole map.
  [[nodiscard]] const std::vector<float>& densities() const { return densities_per_m2_; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::uint32_t group = 0;        ///< stem × 35 + combination
    std::uint32_t fingerprint = 0;  ///< finer distances, so that few groups need their stems
  };
  struct Sorted {
    std::size_t place = 0;  ///< its bucket, then its place in entries_
    Entry entry;
  };
  void find_neighbours(const StemGrid& grid);
  void sort_groups(const StemGrid& grid);
  [[nodiscard]] std::size_t bucket_of(const std::array<std::uint64_t, 5>& bins) const;
  template <class F>
  void for_each_group(const StemGrid& grid, F&& f) const;

  std::size_t bucket_mask_ = 0;
  std::vector<NearStems> near_;
  std::vector<float> densities_per_m2_;
  std::vector<std::uint32_t> starts_;  ///< of each bucket in entries_
  std::vector<Entry> entries_;
};

}  // namespace honka
