#pragma once

#include <memory>
#include <vector>

#include "algo/localize/li2020/li2020.h"

namespace honka {

/// Li2020MatcherIn over a map cut, in plan, into overlapping square tiles, each with a graph of its
/// own; the tiles are asked one by one. Where the whole view lies inside a tile and away from its
/// border, the tile's triangles are the map's.
template <int D>
class SubmapMatcherIn final : public Matcher {
 public:
  /// Tiles of `settings.submap_size_m`, neighbours share `submap_overlap_m`; a tile without a
  /// triangle of three neighbours is left out. Throws UserError where no tile is left, at an
  /// overlap that is not less than the size, and as Li2020MatcherIn does.
  SubmapMatcherIn(const StarPoints<D>& stems_in_map_m, const Li2020Settings& settings);

  using Matcher::locate;
  /// The answer of most agreeing matches, then of least cost a match. Map stems in pairs are those
  /// of the whole map; `map_triangle` is that of the tile's graph. Tiles that the prior's circle
  /// does not touch are not asked.
  [[nodiscard]] LocateResult locate(const StarPoints<D>& stems_in_local_m,
                                    const std::optional<LocatePrior>& prior) const override;

  [[nodiscard]] std::size_t tiles() const { return tiles_.size(); }

 private:
  struct Tile {
    Eigen::Vector2d low_m, high_m;
    std::vector<std::int32_t> stems;  ///< of each of its stems, index into the whole map
    std::unique_ptr<Li2020MatcherIn<D>> matcher;
  };
  void add_tile(const StarPoints<D>& stems_in_map_m, const Eigen::Vector2d& low_m,
                const Li2020Settings& settings);

  std::vector<Tile> tiles_;  ///< by rows of x
};

using SubmapMatcher = SubmapMatcherIn<2>;

}  // namespace honka
