#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace honka {

/// A local stem and a map stem that may be one tree.
struct PossiblePair {
  std::uint32_t local = 0, map = 0;
  double odds = 0.0;  ///< of this pair over "the local stem is false, the map stem not listed"
  double probability = 0.0;  ///< in the end, beside all other pairs
};

/// Sets the probability of every pair where each stem has one partner at most: belief propagation
/// on the graph of pairs, exact where it has no loops (Williams, Lau: Approximate evaluation of
/// marginal association probabilities with belief propagation, IEEE TAES 50(4), 2014). `pairs`:
/// those of one local stem side by side; `map_stems`: above every `map`.
void share_partners(std::span<PossiblePair> pairs, std::size_t map_stems);

}  // namespace honka
