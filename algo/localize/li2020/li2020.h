#pragma once

#include <optional>
#include <vector>

#include "algo/localize/li2020/pairing.h"
#include "algo/localize/li2020/selection.h"
#include "algo/localize/li2020/star_graph.h"
#include "algo/localize/li2020/star_index.h"
#include "algo/localize/matcher.h"

namespace honka {

/// Delaunay-triangulation localization of Li et al. 2020 (§2.8, Eqs. 1–4); the readings of what the
/// paper leaves open are its settings and are listed in the folder's README. With D = 2 the stars
/// lie in the plane, literal to the paper; with D = 3 in space, as its §4.1 proposes: what they
/// measure is then the same however the sensor is tilted.
template <int D>
class Li2020MatcherIn final : public Matcher {
 public:
  /// Triangulates and indexes a map of N stems (metres). Throws UserError at a coordinate not
  /// finite, an unknown word in the settings, settings of the other D, or a map without a triangle
  /// with three neighbours.
  Li2020MatcherIn(const StarPoints<D>& stems_in_map_m, Li2020Settings settings);

  using Matcher::locate;
  [[nodiscard]] LocateResult locate(const StarPoints<D>& stems_in_local_m,
                                    const std::optional<LocatePrior>& prior) const override;

  /// The map's triangulation as build_delaunay gives it, vertices then relative to centre_m().
  [[nodiscard]] const DelaunayGraph& map_graph() const { return map_.delaunay; }
  /// What was subtracted from the map: whole metres near its middle.
  [[nodiscard]] const StarPoint<D>& centre_m() const { return map_.centre_m; }

 private:
  /// A match and its vertices in centred coordinates.
  struct Candidate {
    StarMatch match;
    PoseCandidateIn<D> pose;
  };
  /// A local list as it is matched: its graph, its stars, and where the prior lets it be.
  struct LocalGraph {
    StarGraph<D> graph;
    std::vector<std::int32_t> stem;  ///< of each vertex, index into the list that was given
    std::vector<TriangleStar> stars;
    std::optional<PlaceLimitIn<D>> limit;  ///< centred coordinates to centred coordinates
  };

  [[nodiscard]] LocalGraph local_graph(const StarPoints<D>& stems_in_local_m,
                                       const std::optional<LocatePrior>& prior) const;
  /// The map stars that a local star within the limit could be: all without one.
  [[nodiscard]] StarIndex::Keys active_stars(const LocalGraph& local) const;

  [[nodiscard]] Candidate make_candidate(const TriangleStar& local, const StarGraph<D>& graph,
                                         const TriangleStar& map, const StarLikeness& like) const;
  [[nodiscard]] std::vector<Candidate> match_stars(const LocalGraph& local, int& candidates) const;
  void answer(const LocalGraph& local, const std::vector<Candidate>& kept,
              LocateResult& result) const;

  Li2020Settings settings_;
  Pairing pairing_ = Pairing::kSimilarEdge;
  StarGraph<D> map_;
  StarIndex index_;
  /// Of each map star: its first corner, and how far its other vertices are from it at most.
  struct StarPlace {
    StarPoint<D> corner_m;
    double span_m = 0.0;
  };
  std::vector<StarPlace> places_;
};

/// Literal to the paper: stars in the plane.
using Li2020Matcher = Li2020MatcherIn<2>;

}  // namespace honka
