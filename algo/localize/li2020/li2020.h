#pragma once

#include <Eigen/Core>
#include <functional>
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
  /// Whether a prior allows a pose, centred coordinates to centred coordinates.
  using PlaceFilter = std::function<bool(const Pose2&)>;

  [[nodiscard]] Candidate make_candidate(const TriangleStar& local, const DelaunayGraph& graph,
                                         const TriangleStar& map, const StarLikeness& like) const;
  [[nodiscard]] std::vector<Candidate> match_stars(const std::vector<TriangleStar>& local_stars,
                                                   const DelaunayGraph& graph,
                                                   const PlaceFilter& allows,
                                                   int& candidates) const;
  [[nodiscard]] Selection select(const std::vector<Candidate>& kept) const;

  Li2020Settings settings_;
  Pairing pairing_ = Pairing::kSimilarEdge;
  Eigen::Vector2d centre_m_ = Eigen::Vector2d::Zero();
  DelaunayGraph map_;
  StarIndex index_;
};

}  // namespace honka
