#pragma once

#include <cstddef>
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

  /// Appends the indices into stars() of centres within the tolerance of `local`, ascending.
  void find(const TriangleStar& local, double tolerance_m2, std::vector<std::size_t>& found) const;

 private:
  struct Key {
    double perimeter_squared_m2;
    std::size_t star;
  };
  std::vector<TriangleStar> stars_;
  std::vector<Key> keys_;  ///< ascending in perimeter_squared_m2, then star
};

}  // namespace honka
