#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace honka {

/// Union-find over 0 … n − 1; the root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }
  [[nodiscard]] std::uint32_t root(std::uint32_t item) {
    while (parents_[item] != item) {
      parents_[item] = parents_[parents_[item]];
      item = parents_[item];
    }
    return item;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    std::uint32_t low = root(a), high = root(b);
    if (low > high) std::swap(low, high);
    parents_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace honka
