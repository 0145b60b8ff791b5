#include "algo/localize/li2020/star_index.h"

#include <algorithm>
#include <utility>

namespace honka {

StarIndex::StarIndex(std::vector<TriangleStar> stars) : stars_(std::move(stars)) {
  keys_.reserve(stars_.size());
  for (std::size_t i = 0; i < stars_.size(); ++i) {
    keys_.push_back({stars_[i].perimeter_squared_m2[0], i});
  }
  std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
    return std::pair(a.perimeter_squared_m2, a.star) < std::pair(b.perimeter_squared_m2, b.star);
  });
}

StarIndex::Keys StarIndex::active(const std::function<bool(std::size_t)>& is_active) const {
  Keys chosen;
  for (const Key& key : keys_) {
    if (is_active(key.star)) chosen.push_back(key);
  }
  return chosen;
}

void StarIndex::find(const Keys& keys, const TriangleStar& local, double tolerance_m2,
                     std::vector<std::size_t>& found) const {
  // A hair wider than the tolerance: l ± tolerance is rounded, the comparison below decides.
  const double l = local.perimeter_squared_m2[0];
  const double reach = tolerance_m2 + 1e-12 * (l + tolerance_m2);
  const auto first = std::lower_bound(
      keys.begin(), keys.end(), l - reach,
      [](const Key& key, double value) { return key.perimeter_squared_m2 < value; });
  const auto begin = static_cast<std::ptrdiff_t>(found.size());
  for (auto key = first; key != keys.end() && key->perimeter_squared_m2 <= l + reach; ++key) {
    if (centre_dissimilarity_m2(local, stars_[key->star]) <= tolerance_m2) {
      found.push_back(key->star);
    }
  }
  std::sort(found.begin() + begin, found.end());
}

}  // namespace honka
