#include "algo/localize/consensus/partners.h"

#include <algorithm>

namespace honka {

void share_partners(std::span<PossiblePair> pairs, std::size_t map_stems) {
  constexpr int kRounds = 6;  // of messages; loops are short and weak between trees
  thread_local std::vector<double> to_map, free_share, claimed;
  to_map.assign(pairs.size(), 0.0);
  free_share.assign(pairs.size(), 1.0);  // of the map stem, as the local stem hears it
  const auto each_local = [&](const auto& act) {
    for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
      double sum = 1.0;
      while (end < pairs.size() && pairs[end].local == pairs[begin].local) {
        sum += pairs[end].odds * free_share[end];
        ++end;
      }
      for (std::size_t k = begin; k < end; ++k) act(k, sum);
    }
  };
  for (int round = 0; round < kRounds; ++round) {
    claimed.assign(map_stems, 0.0);
    each_local([&](std::size_t k, double sum) {
      const double others = std::max(sum - pairs[k].odds * free_share[k], 1.0);
      to_map[k] = pairs[k].odds / others;
      claimed[pairs[k].map] += to_map[k];
    });
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      free_share[k] = 1.0 / (1.0 + std::max(claimed[pairs[k].map] - to_map[k], 0.0));
    }
  }
  each_local([&](std::size_t k, double sum) {
    pairs[k].probability = pairs[k].odds * free_share[k] / sum;
  });
}

}  // namespace honka
