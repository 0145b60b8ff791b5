#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/localize/consensus/group_table.h"
#include "algo/localize/consensus/stem_grid.h"

namespace honka {

/// 64-bit hash of a map's stems, in their order; −0 counts as 0.
[[nodiscard]] std::uint64_t map_hash(std::span<const Eigen::Vector2d> stems_in_map_m);

/// What the matcher `consensus` knows of a map: immutable, built once, shared
/// by matchers and threads. Coordinates inside are relative to centre_m().
class ConsensusIndex {
 public:
  /// From N ≥ 3 stems at three places or more (metres; UTM-sized coordinates
  /// keep millimetres). Throws UserError at a coordinate not finite or a
  /// smaller map.
  explicit ConsensusIndex(std::span<const Eigen::Vector2d> stems_in_map_m);

  /// A little-endian buffer with a versioned header, the map's hash, its length
  /// and a checksum.
  [[nodiscard]] std::vector<std::uint8_t> to_bytes() const;
  /// Throws UserError with the reason at a buffer that is short, damaged or
  /// something else.
  [[nodiscard]] static ConsensusIndex from_bytes(std::span<const std::uint8_t> bytes);

  /// map_hash of the list it was built from.
  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  /// What was subtracted from the map: whole metres near its middle.
  [[nodiscard]] const Eigen::Vector2d& centre_m() const { return centre_m_; }
  [[nodiscard]] const StemGrid& grid() const { return grid_; }
  [[nodiscard]] const GroupTable& groups() const { return groups_; }

 private:
  ConsensusIndex() = default;

  std::uint64_t hash_ = 0;
  Eigen::Vector2d centre_m_ = Eigen::Vector2d::Zero();
  StemGrid grid_;
  GroupTable groups_;
};

}  // namespace honka
