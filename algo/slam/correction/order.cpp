#include "algo/slam/correction/order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka {
namespace {

double median_gap(std::span<const FramePair> pairs) {
  std::vector<double> gaps;
  for (const FramePair& pair : pairs) gaps.push_back(pair.gap());
  std::sort(gaps.begin(), gaps.end());
  const std::size_t middle = gaps.size() / 2;
  return gaps.size() % 2 == 1 ? gaps[middle] : 0.5 * (gaps[middle - 1] + gaps[middle]);
}

std::vector<double> sorting_keys(std::span<const FramePair> pairs, CorrectionOrder order,
                                 std::uint64_t seed) {
  const double median = median_gap(pairs);
  RandomStream random(seed, "correction_order");
  std::vector<double> keys;
  for (const FramePair& pair : pairs) {
    switch (order) {
      case CorrectionOrder::kSmallGapsFirst:
        keys.push_back(pair.gap());
        break;
      case CorrectionOrder::kMediumGapsFirst:
        keys.push_back(std::abs(pair.gap() - median));
        break;
      case CorrectionOrder::kRandom:
        keys.push_back(random.uniform());
        break;
    }
  }
  return keys;
}

}  // namespace

const std::vector<std::string>& correction_order_names() {
  static const std::vector<std::string> kNames = {"small_gaps_first", "medium_gaps_first",
                                                  "random"};
  return kNames;
}

CorrectionOrder correction_order(const std::string& name) {
  const auto& names = correction_order_names();
  const auto found = std::find(names.begin(), names.end(), name);
  HONKA_CHECK(found != names.end(), "the name of an order");
  return static_cast<CorrectionOrder>(found - names.begin());
}

std::vector<std::size_t> order_corrections(std::span<const FramePair> pairs, CorrectionOrder order,
                                           std::uint64_t seed) {
  if (pairs.empty()) return {};
  const std::vector<double> keys = sorting_keys(pairs, order, seed);
  std::vector<std::size_t> indices(pairs.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::stable_sort(indices.begin(), indices.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return indices;
}

}  // namespace honka
