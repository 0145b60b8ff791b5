#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// A triangle and its three neighbours as six vertices: 0, 1, 2 the centre; 3 + k the far vertex
/// of the neighbour across the edge opposite vertex k.
using StarVertices = std::array<Eigen::Vector2d, 6>;

/// The four triangles of a star as closed lines, the centre first.
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> star_outlines(const StarVertices& star);

using Edges = std::vector<std::array<Eigen::Vector2d, 2>>;

/// Li2020 Fig. 6: the target star, all matched stars of the local graph, and theirs in the map.
struct MatchedStarsFigure {
  Edges local_edges;    ///< triangulation in the local frame, m
  Edges map_edges;      ///< in the map frame, m; what lies far from the matches is cut off
  StarVertices target;  ///< of the local graph
  std::vector<StarVertices> local_stars;  ///< matched, local frame
  std::vector<StarVertices> map_stars;    ///< as many: their partners, map frame
  std::string protocol;
};

[[nodiscard]] ReportFigure draw_matched_stars(const std::filesystem::path& folder,
                                              const MatchedStarsFigure& input);

/// Li2020 Fig. 7: one matched pair of stars; vertex i of the local star pairs with vertex i of the
/// map star. A, B, C – M, H, N are the centres' vertices; D, E, F – Q, R, T the neighbours'.
struct PairingFigure {
  StarVertices local_star, map_star;
  std::string protocol;
};

[[nodiscard]] ReportFigure draw_pairing(const std::filesystem::path& folder,
                                        const PairingFigure& input);

}  // namespace honka::eval
