#include "algo/localize/li2020/li2020.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "algo/localize/li2020/branch_and_bound.h"
#include "algo/localize/li2020/covariance.h"
#include "algo/localize/li2020/star_pose.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Whole metres near the middle.
Eigen::Vector2d middle_of(const Points& points) {
  if (points.empty()) return Eigen::Vector2d::Zero();
  Eigen::Vector2d low = points[0];
  Eigen::Vector2d high = points[0];
  for (const Eigen::Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d middle = (0.5 * (low + high)).array().round();
  return middle.allFinite() ? middle : Eigen::Vector2d::Zero();
}

/// The triangulation of the points as given, its vertices then relative to the centre.
DelaunayGraph centred_delaunay(const Points& points, const Eigen::Vector2d& centre) {
  DelaunayGraph graph = build_delaunay(points);
  for (Eigen::Vector2d& vertex : graph.vertices) vertex -= centre;
  return graph;
}

void check_word(std::string_view key, const std::string& word,
                const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  throw UserError(
      fmt::format("li2020.{} is \"{}\"; choose {}", key, word, fmt::join(known, " or ")));
}

/// From centred coordinates back to those of the lists that were given.
void restore_frames(StarMatch& match, const Eigen::Vector2d& local_centre,
                    const Eigen::Vector2d& map_centre) {
  match.printed_translation_m += map_centre - local_centre;
  match.translation_m += map_centre - Eigen::Rotation2Dd(match.theta_rad) * local_centre;
}

int count_inliers(const std::vector<StarMatch>& matches) {
  std::set<std::int32_t> stems;
  for (const StarMatch& match : matches) {
    if (!match.agrees) continue;
    for (const VertexPair& pair : match.pairs) stems.insert(pair.local);
  }
  return static_cast<int>(stems.size());
}

}  // namespace

Li2020Matcher::Li2020Matcher(const Points& stems_in_map_m, Li2020Settings settings)
    : settings_(std::move(settings)), centre_m_(middle_of(stems_in_map_m)) {
  check_word("pairing", settings_.pairing, {"similar_edge", "least_side_sum"});
  check_word("selection", settings_.selection, {"candidates", "box", "branch_and_bound"});
  if (settings_.pairing == "least_side_sum") pairing_ = Pairing::kLeastSideSum;
  map_ = centred_delaunay(stems_in_map_m, centre_m_);
  index_ = StarIndex(stars_of(map_, StarChoice::kThreeNeighbours));
  if (index_.stars().empty()) {
    throw UserError(fmt::format(
        "the map has {} stems and no triangle with three neighbours; give a map of more stems",
        stems_in_map_m.size()));
  }
  for (const TriangleStar& star : index_.stars()) {
    const auto vertex = [&](std::size_t k) -> const Eigen::Vector2d& {
      return map_.vertices[static_cast<std::size_t>(star.vertices[k])];
    };
    StarPlace place{vertex(0)};
    for (std::size_t k = 1; k < 6; ++k) {
      place.span_m = std::max(place.span_m, (vertex(k) - vertex(0)).norm());
    }
    places_.push_back(place);
  }
}

Li2020Matcher::Candidate Li2020Matcher::make_candidate(const TriangleStar& local,
                                                       const DelaunayGraph& graph,
                                                       const TriangleStar& map,
                                                       const StarLikeness& like) const {
  Candidate c;
  c.match.local_triangle = local.triangle;
  c.match.map_triangle = map.triangle;
  c.match.rotation = like.rotation;
  c.match.dissimilarity_m2 = like.dissimilarity_m2;
  c.match.pairs = pair_vertices(local, graph.vertices, map, map_.vertices, pairing_);
  for (std::size_t j = 0; j < 6; ++j) {
    c.pose.local_m[j] = graph.vertices[static_cast<std::size_t>(c.match.pairs[j].local)];
    c.pose.map_m[j] = map_.vertices[static_cast<std::size_t>(c.match.pairs[j].map)];
  }
  const StarPose pose = star_pose(c.pose.local_m, c.pose.map_m);
  c.match.theta_rad = pose.theta_rad;
  c.match.printed_translation_m = pose.printed_translation_m;
  c.match.translation_m = pose.translation_m;
  c.match.cost_m = pose.cost_m;
  c.pose.T_map_local = {pose.translation_m, pose.theta_rad};
  return c;
}

Li2020Matcher::LocalGraph Li2020Matcher::local_graph(
    const Points& stems_in_local_m, const std::optional<LocatePrior>& prior) const {
  const double radius_m = settings_.local_radius_m;
  LocalGraph local;
  Points near_m;
  for (std::size_t i = 0; i < stems_in_local_m.size(); ++i) {
    // Not "> radius": what is not finite goes on to the triangulation, which names it.
    if (radius_m > 0.0 && stems_in_local_m[i].norm() > radius_m) continue;
    near_m.push_back(stems_in_local_m[i]);
    local.stem.push_back(static_cast<std::int32_t>(i));
  }
  local.centre_m = middle_of(near_m);
  local.graph = centred_delaunay(near_m, local.centre_m);
  local.stars = stars_of(local.graph, StarChoice::kNoHullVertex);
  if (prior) {
    local.limit =
        PlaceLimit{-local.centre_m, prior->position_in_map_m - centre_m_, prior->radius_m};
  }
  return local;
}

// A match's pose maps the mean of its local vertices onto that of its map vertices. So the sensor's
// place is no farther from any of the map star's corners than the local stars reach plus what that
// star spans.
StarIndex::Keys Li2020Matcher::active_stars(const LocalGraph& local) const {
  double reach_m = 0.0;
  for (const Eigen::Vector2d& v : local.graph.vertices) {
    reach_m = std::max(reach_m, (v - local.limit->local_m).norm());
  }
  const double near_m = local.limit->radius_m + reach_m;
  return index_.active([&](std::size_t i) {
    const double reach = near_m + places_[i].span_m;
    return (places_[i].corner_m - local.limit->map_m).squaredNorm() <= reach * reach;
  });
}

std::vector<Li2020Matcher::Candidate> Li2020Matcher::match_stars(const LocalGraph& local,
                                                                 int& candidates) const {
  const double gate_m = settings_.vertex_gate_m;
  const StarIndex::Keys active = local.limit ? active_stars(local) : StarIndex::Keys{};
  const StarIndex::Keys& keys = local.limit ? active : index_.all();
  std::vector<Candidate> kept;
  std::vector<std::size_t> found;
  for (const TriangleStar& star : local.stars) {
    found.clear();
    index_.find(keys, star, settings_.tolerance_m2, found);
    std::optional<Candidate> best;
    for (const std::size_t i : found) {
      const TriangleStar& map = index_.stars()[i];
      const auto like = compare_stars(star, map, settings_.tolerance_m2,
                                      static_cast<int>(settings_.neighbours_required));
      if (!like) continue;
      ++candidates;
      if (best && like->dissimilarity_m2 >= best->match.dissimilarity_m2) continue;
      Candidate c = make_candidate(star, local.graph, map, *like);
      if (local.limit && !local.limit->allows(c.pose.T_map_local)) continue;
      if (gate_m > 0.0 && largest_residual_m(c.pose, c.pose.T_map_local) > gate_m) continue;
      best = std::move(c);
    }
    if (best) kept.push_back(std::move(*best));
  }
  return kept;
}

Selection Li2020Matcher::select(const std::vector<Candidate>& kept,
                                const std::optional<PlaceLimit>& limit) const {
  std::vector<PoseCandidate> poses;
  for (const Candidate& c : kept) poses.push_back(c.pose);
  if (settings_.selection == "branch_and_bound") return select_by_bound(poses, limit).best;
  return settings_.selection == "box" ? select_in_box(poses, limit) : select_candidate(poses);
}

// The pose of Eq. (4) and the matches that agree with it
void Li2020Matcher::answer(const LocalGraph& local, const std::vector<Candidate>& kept,
                           LocateResult& result) const {
  const Selection selection = select(kept, local.limit);
  std::vector<PoseCandidate> agreeing;
  for (const Candidate& c : kept) {
    StarMatch match = c.match;
    match.residual_m = mean_residual_m(c.pose, selection.T_map_local);
    match.agrees = match.residual_m < settings_.agreement_m;
    if (match.agrees) agreeing.push_back(c.pose);
    restore_frames(match, local.centre_m, centre_m_);
    for (VertexPair& pair : match.pairs) {
      pair.local = local.stem[static_cast<std::size_t>(pair.local)];
    }
    result.star_matches.push_back(match);
  }
  result.agreeing = static_cast<int>(agreeing.size());
  result.chosen = static_cast<int>(selection.chosen);
  result.cost_m = selection.cost_m;
  result.inliers = count_inliers(result.star_matches);
  result.margin = static_cast<double>(result.agreeing) / static_cast<double>(result.matches);
  const double yaw = selection.T_map_local.yaw_rad;
  result.T_map_local = {
      selection.T_map_local.translation_m + centre_m_ - Eigen::Rotation2Dd(yaw) * local.centre_m,
      wrap_to_pi(yaw)};
  if (result.agreeing < settings_.min_agreeing) return;
  result.verdict = Verdict::kAccepted;
  result.covariance = pose_covariance(agreeing, kept[selection.chosen].pose, selection.T_map_local,
                                      -local.centre_m);
}

LocateResult Li2020Matcher::locate(const Points& stems_in_local_m,
                                   const std::optional<LocatePrior>& prior) const {
  check_prior(prior);
  LocateResult result;
  result.stems = static_cast<int>(stems_in_local_m.size());
  // Local graph and its stars (Li2020 §2.7, §2.8)
  const LocalGraph local = local_graph(stems_in_local_m, prior);
  result.local_stars = static_cast<int>(local.stars.size());
  if (local.stars.empty()) return result;
  // Matches, each with the pose of Eqs. (1)–(3)
  const auto kept = match_stars(local, result.candidates);
  result.matches = static_cast<int>(kept.size());
  result.verdict = Verdict::kNotInMap;
  if (!kept.empty()) answer(local, kept, result);
  return result;
}

}  // namespace honka
