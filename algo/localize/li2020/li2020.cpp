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
#include "algo/localize/li2020/star_frames.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

void check_word(std::string_view key, const std::string& word,
                const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  throw UserError(
      fmt::format("li2020.{} is \"{}\"; choose {}", key, word, fmt::join(known, " or ")));
}

void check_settings(const Li2020Settings& settings, bool with_heights) {
  check_word("pairing", settings.pairing, {"similar_edge", "least_side_sum"});
  check_word("selection", settings.selection, {"candidates", "box", "branch_and_bound"});
  check_word("stars", settings.stars, {"plane", "space"});
  if (!with_heights && settings.stars == "space") {
    throw UserError(
        "li2020.stars is \"space\", and the map has stems without heights; give z_m of each, or "
        "set "
        "it to \"plane\"");
  }
  if (with_heights && settings.selection != "candidates") {
    throw UserError(fmt::format(
        "li2020.selection is \"{}\", which takes stars in the plane alone; with li2020.stars = "
        "\"space\" choose \"candidates\"",
        settings.selection));
  }
}

/// Li2020 Eq. (4) as the settings have it.
Selection select(const std::vector<PoseCandidate>& poses, const std::optional<PlaceLimit>& limit,
                 const std::string& selection) {
  if (selection == "branch_and_bound") return select_by_bound(poses, limit).best;
  return selection == "box" ? select_in_box(poses, limit) : select_candidate(poses);
}

SelectionIn<3> select(const std::vector<PoseCandidateIn<3>>& poses,
                      const std::optional<PlaceLimitIn<3>>&, const std::string&) {
  return select_candidate(poses);  // one of theirs, which the limit allows
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

template <int D>
Li2020MatcherIn<D>::Li2020MatcherIn(const StarPoints<D>& stems_in_map_m, Li2020Settings settings)
    : settings_(std::move(settings)) {
  check_settings(settings_, D == 3);
  if (settings_.pairing == "least_side_sum") pairing_ = Pairing::kLeastSideSum;
  map_ = star_graph<D>(stems_in_map_m);
  index_ = StarIndex(stars_of(map_.delaunay, StarChoice::kThreeNeighbours));
  if (index_.stars().empty()) {
    throw UserError(fmt::format(
        "the map has {} stems and no triangle with three neighbours; give a map of more stems",
        stems_in_map_m.size()));
  }
  for (const TriangleStar& star : index_.stars()) {
    const auto vertex = [&](std::size_t k) -> const StarPoint<D>& {
      return map_.vertices_m[static_cast<std::size_t>(star.vertices[k])];
    };
    StarPlace place{vertex(0)};
    for (std::size_t k = 1; k < 6; ++k) {
      place.span_m = std::max(place.span_m, (vertex(k) - vertex(0)).norm());
    }
    places_.push_back(place);
  }
}

template <int D>
auto Li2020MatcherIn<D>::make_candidate(const TriangleStar& local, const StarGraph<D>& graph,
                                        const TriangleStar& map, const StarLikeness& like) const
    -> Candidate {
  Candidate c;
  c.match.local_triangle = local.triangle;
  c.match.map_triangle = map.triangle;
  c.match.rotation = like.rotation;
  c.match.dissimilarity_m2 = like.dissimilarity_m2;
  c.match.pairs = pair_vertices<D>(local, graph.vertices_m, map, map_.vertices_m, pairing_);
  for (std::size_t j = 0; j < 6; ++j) {
    c.pose.local_m[j] = graph.vertices_m[static_cast<std::size_t>(c.match.pairs[j].local)];
    c.pose.map_m[j] = map_.vertices_m[static_cast<std::size_t>(c.match.pairs[j].map)];
  }
  set_pose(star_pose(c.pose.local_m, c.pose.map_m), c.pose, c.match);
  return c;
}

template <int D>
auto Li2020MatcherIn<D>::local_graph(const StarPoints<D>& stems_in_local_m,
                                     const std::optional<LocatePrior>& prior) const -> LocalGraph {
  const double radius_m = settings_.local_radius_m;
  LocalGraph local;
  StarPoints<D> near_m;
  for (std::size_t i = 0; i < stems_in_local_m.size(); ++i) {
    // Not "> radius": what is not finite goes on to the triangulation, which names it.
    if (radius_m > 0.0 && stems_in_local_m[i].norm() > radius_m) continue;
    near_m.push_back(stems_in_local_m[i]);
    local.stem.push_back(static_cast<std::int32_t>(i));
  }
  local.graph = star_graph<D>(near_m);
  local.stars = stars_of(local.graph.delaunay, StarChoice::kNoHullVertex);
  if (prior) {
    const Eigen::Vector2d map_centre_m = map_.centre_m.template head<2>();
    local.limit = PlaceLimitIn<D>{-local.graph.centre_m, prior->position_in_map_m - map_centre_m,
                                  prior->radius_m};
  }
  return local;
}

// A match's pose maps the mean of its local vertices onto that of its map vertices. So the sensor's
// place is no farther from any of the map star's corners than the local stars reach plus what that
// star spans; in space neither is longer in plan.
template <int D>
StarIndex::Keys Li2020MatcherIn<D>::active_stars(const LocalGraph& local) const {
  double reach_m = 0.0;
  for (const StarPoint<D>& v : local.graph.vertices_m) {
    reach_m = std::max(reach_m, (v - local.limit->local_m).norm());
  }
  const double near_m = local.limit->radius_m + reach_m;
  return index_.active([&](std::size_t i) {
    const double reach = near_m + places_[i].span_m;
    const Eigen::Vector2d corner_m = places_[i].corner_m.template head<2>();
    return (corner_m - local.limit->map_m).squaredNorm() <= reach * reach;
  });
}

template <int D>
auto Li2020MatcherIn<D>::match_stars(const LocalGraph& local, int& candidates) const
    -> std::vector<Candidate> {
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

// The pose of Eq. (4) and the matches that agree with it
template <int D>
void Li2020MatcherIn<D>::answer(const LocalGraph& local, const std::vector<Candidate>& kept,
                                LocateResult& result) const {
  std::vector<PoseCandidateIn<D>> poses, agreeing;
  for (const Candidate& c : kept) poses.push_back(c.pose);
  const SelectionIn<D> selection = select(poses, local.limit, settings_.selection);
  for (const Candidate& c : kept) {
    StarMatch match = c.match;
    match.residual_m = mean_residual_m(c.pose, selection.T_map_local);
    match.agrees = match.residual_m < settings_.agreement_m;
    if (match.agrees) agreeing.push_back(c.pose);
    restore_frames(match, c.pose.T_map_local, local.graph.centre_m, map_.centre_m);
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
  set_answer(result, selection.T_map_local, local.graph.centre_m, map_.centre_m);
  if (result.agreeing < settings_.min_agreeing) return;
  result.verdict = Verdict::kAccepted;
  if constexpr (D == 2) {
    result.covariance = pose_covariance(agreeing, poses[selection.chosen], selection.T_map_local,
                                        -local.graph.centre_m);
  }
}

template <int D>
LocateResult Li2020MatcherIn<D>::locate(const StarPoints<D>& stems_in_local_m,
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

template class Li2020MatcherIn<2>;
template class Li2020MatcherIn<3>;

}  // namespace honka
