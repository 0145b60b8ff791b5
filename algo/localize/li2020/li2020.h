#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "algo/localize/li2020/pairing.h"
#include "algo/localize/li2020/selection.h"
#include "algo/localize/li2020/star_index.h"
#include "algo/localize/matcher.h"

namespace honka {

/// Delaunay-triangulation localization, literal to Li et al. 2020 (§2.8, Eqs. 1–4); the readings of
/// what the paper leaves open are its settings and are listed in the folder's README.
class Li2020Matcher final : public Matcher {
 public:
  /// Triangulates and indexes a map of N stems (metres). Throws UserError at a coordinate not
  /// finite, an unknown word in the settings, or a map without a triangle with three neighbours.
  Li2020Matcher(const std::vector<Eigen::Vector2d>& stems_in_map_m, Li2020Settings settings);

  using Matcher::locate;
  [[nodiscard]] LocateResult locate(const std::vector<Eigen::Vector2d>& stems_in_local_m,
                                    const std::optional<LocatePrior>& prior) const override;

  /// The map's triangulation as build_delaunay gives it, vertices then relative to centre_m().
  [[nodiscard]] const DelaunayGraph& map_graph() const { return map_; }
  /// What was subtracted from the map: whole metres near its middle.
  [[nodiscard]] const Eigen::Vector2d& centre_m() const { return centre_m_; }

 private:
  /// A match and its vertices in centred coordinates.
  struct Candidate {
    StarMatch match;
    PoseCandidate pose;
  };
  /// A local list as it is matched: its graph, its stars, and where the prior lets it be.
  struct LocalGraph {
    DelaunayGraph graph;  ///< vertices relative to `centre_m`
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    std::vector<std::int32_t> stem;  ///< of each vertex, index into the list that was given
    std::vector<TriangleStar> stars;
    std::optional<PlaceLimit> limit;  ///< centred coordinates to centred coordinates
  };

  [[nodiscard]] LocalGraph local_graph(const std::vector<Eigen::Vector2d>& stems_in_local_m,
                                       const std::optional<LocatePrior>& prior) const;
  /// The map stars that a local star within the limit could be: all without one.
  [[nodiscard]] StarIndex::Keys active_stars(const LocalGraph& local) const;

  [[nodiscard]] Candidate make_candidate(const TriangleStar& local, const DelaunayGraph& graph,
                                         const TriangleStar& map, const StarLikeness& like) const;
  [[nodiscard]] std::vector<Candidate> match_stars(const LocalGraph& local, int& candidates) const;
  [[nodiscard]] Selection select(const std::vector<Candidate>& kept,
                                 const std::optional<PlaceLimit>& limit) const;
  void answer(const LocalGraph& local, const std::vector<Candidate>& kept,
              LocateResult& result) const;

  Li2020Settings settings_;
  Pairing pairing_ = Pairing::kSimilarEdge;
  Eigen::Vector2d centre_m_ = Eigen::Vector2d::Zero();
  DelaunayGraph map_;
  StarIndex index_;
  /// Of each map star: its first corner, and how far its other vertices are from it at most.
  struct StarPlace {
    Eigen::Vector2d corner_m;
    double span_m = 0.0;
  };
  std::vector<StarPlace> places_;
};

}  // namespace honka
