#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace honka {

/// A point of a tree found by a search.
struct Neighbour {
  std::uint32_t index = 0;  ///< into the points the tree was built from
  double distance_m = 0.0;  ///< to the query
};

/// Static k-d tree over points in the plane (Dim 2) or in space (Dim 3).
///
/// Holds a view: the points must outlive the tree and stay where they are. Coordinates must be
/// finite. Searches are const and may run in parallel. "Within a radius" is strict: d < radius.
template <int Dim>
class KdTree {
 public:
  using Point = Eigen::Matrix<double, Dim, 1>;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  explicit KdTree(std::span<const Point> points);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  /// The nearest point; nothing from an empty tree.
  [[nodiscard]] std::optional<Neighbour> nearest(const Point& query) const;
  /// Up to `count` nearest points, nearest first, equal distances by index.
  [[nodiscard]] std::vector<Neighbour> nearest(const Point& query, std::size_t count) const;
  /// All points within the radius, in order of index.
  [[nodiscard]] std::vector<std::uint32_t> within(const Point& query, double radius_m) const;
  /// The same into `found` (cleared first, unordered), without allocation once it has grown.
  void within(const Point& query, double radius_m, std::vector<std::uint32_t>& found) const;
  /// Whether any point other than `skip` lies within the radius; stops at the first.
  [[nodiscard]] bool any_within(const Point& query, double radius_m,
                                std::uint32_t skip = kNone) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

using KdTree2 = KdTree<2>;
using KdTree3 = KdTree<3>;

extern template class KdTree<2>;
extern template class KdTree<3>;

}  // namespace honka
