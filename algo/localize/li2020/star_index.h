#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "algo/localize/li2020/star.h"

namespace honka {

/// The stars of a map sorted by the squared perimeter of their centre, so that a local star is
/// compared with a narrow slice of the map only. Finds exactly what comparing with all finds.
class StarIndex {
 public:
  StarIndex() = default;
  explicit StarIndex(std::vector<TriangleStar> stars);

  [[nodiscard]] const std::vector<TriangleStar>& stars() const { return stars_; }

  struct Key {
    double perimeter_squared_m2;
    std::size_t star;
  };
  /// Ascending in perimeter_squared_m2, then star.
  using Keys = std::vector<Key>;

  /// Every star, and those alone that `is_active` of their index into stars().
  [[nodiscard]] const Keys& all() const { return keys_; }
  [[nodiscard]] Keys active(const std::function<bool(std::size_t)>& is_active) const;

  /// Appends the indices into stars() of centres among `keys` within the tolerance of `local`,
  /// ascending.
  void find(const Keys& keys, const TriangleStar& local, double tolerance_m2,
            std::vector<std::size_t>& found) const;
  /// The same among all.
  void find(const TriangleStar& local, double tolerance_m2, std::vector<std::size_t>& found) const {
    find(keys_, local, tolerance_m2, found);
  }

 private:
  std::vector<TriangleStar> stars_;
  Keys keys_;
};

}  // namespace honka
