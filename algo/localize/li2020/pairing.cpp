#include "algo/localize/li2020/pairing.h"

#include <cmath>

namespace honka {
namespace {

template <int D>
using Corners = std::array<StarPoint<D>, 3>;

template <int D>
Corners<D> corners_of(const TriangleStar& star, const StarPoints<D>& points) {
  return {points[static_cast<std::size_t>(star.vertices[0])],
          points[static_cast<std::size_t>(star.vertices[1])],
          points[static_cast<std::size_t>(star.vertices[2])]};
}

/// Length of the side opposite each corner.
template <int D>
std::array<double, 3> sides(const Corners<D>& c) {
  return {(c[2] - c[1]).norm(), (c[0] - c[2]).norm(), (c[1] - c[0]).norm()};
}

/// Seen from above.
template <int D>
double cross(const StarPoint<D>& a, const StarPoint<D>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Per local corner the map corner: A ↔ M opposite the most similar sides, the rest by Eq. (2).
template <int D>
std::array<std::size_t, 3> by_similar_edge(const Corners<D>& local, const Corners<D>& map) {
  const auto a = sides<D>(local);
  const auto b = sides<D>(map);
  std::size_t A = 0;
  std::size_t M = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (std::abs(a[i] - b[j]) < std::abs(a[A] - b[M])) {
        A = i;
        M = j;
      }
    }
  }
  const std::size_t B = (A + 1) % 3;
  const std::size_t C = (A + 2) % 3;
  const std::size_t N = (M + 1) % 3;
  const std::size_t H = (M + 2) % 3;
  // Li2020 Eq. (2): a = (CA × CB) · (HM × HN). Zero, which only rounding gives, counts as the same
  // side: the corners of both triangles are counter-clockwise.
  const double side = cross<D>(local[A] - local[C], local[B] - local[C]) *
                      cross<D>(map[M] - map[H], map[N] - map[H]);
  std::array<std::size_t, 3> f{};
  f[A] = M;
  f[C] = side >= 0.0 ? H : N;  // the text's "(C, M)" is read as (C, N)
  f[B] = side >= 0.0 ? N : H;
  return f;
}

template <int D>
std::array<std::size_t, 3> by_least_side_sum(const Corners<D>& local, const Corners<D>& map) {
  const auto a = sides<D>(local);
  const auto b = sides<D>(map);
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t rotation = 0; rotation < 3; ++rotation) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(a[k] - b[(k + rotation) % 3]);
    if (sum < least) {
      least = sum;
      best = rotation;
    }
  }
  return {best, (best + 1) % 3, (best + 2) % 3};
}

}  // namespace

template <int D>
std::array<VertexPair, 6> pair_vertices(const TriangleStar& local, const StarPoints<D>& in_local_m,
                                        const TriangleStar& map, const StarPoints<D>& in_map_m,
                                        Pairing pairing) {
  const auto local_corners = corners_of<D>(local, in_local_m);
  const auto map_corners = corners_of<D>(map, in_map_m);
  const auto f = pairing == Pairing::kSimilarEdge
                     ? by_similar_edge<D>(local_corners, map_corners)
                     : by_least_side_sum<D>(local_corners, map_corners);
  std::array<VertexPair, 6> pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    pairs[k] = {local.vertices[k], map.vertices[f[k]]};
    pairs[k + 3] = {local.vertices[k + 3], map.vertices[f[k] + 3]};
  }
  return pairs;
}

template std::array<VertexPair, 6> pair_vertices(const TriangleStar&, const StarPoints<2>&,
                                                 const TriangleStar&, const StarPoints<2>&,
                                                 Pairing);
template std::array<VertexPair, 6> pair_vertices(const TriangleStar&, const StarPoints<3>&,
                                                 const TriangleStar&, const StarPoints<3>&,
                                                 Pairing);

}  // namespace honka
