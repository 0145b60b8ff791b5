#include <fmt/format.h>

#include <algorithm>

#include "eval/report/figure_map_cloud.h"
#include "eval/report/figure_matched_stars.h"
#include "eval/report/figure_segmentation.h"
#include "eval/report/figure_stand.h"
#include "eval/run/localization_figures.h"

namespace honka::eval {
namespace {

std::vector<Eigen::Vector2d> track_of(const Drive& drive) {
  std::vector<Eigen::Vector2d> track;
  for (const KeyFrame& key_frame : drive.key_frames) {
    track.push_back((drive.T_world_odom * key_frame.T_odom_lidar).translation().head<2>());
  }
  return track;
}

ReportFigure stand(const std::filesystem::path& folder, const TrialExhibit& exhibit) {
  StandFigure figure;
  figure.stems = true_stems(exhibit.world.stand);
  figure.roads = {exhibit.world.prior_path};
  figure.work_path = exhibit.world.work_path;
  for (const Window& window : exhibit.windows) {
    figure.window_starts.push_back(
        exhibit.work.key_frames[window.last_key_frame].T_world_lidar.translation().head<2>());
  }
  figure.protocol = fmt::format("stand 0: {} trees, {} windows", figure.stems.size(),
                                figure.window_starts.size());
  return draw_stand(folder, figure);
}

ReportFigure map_cloud(const std::filesystem::path& folder, const TrialExhibit& exhibit) {
  const TrunkMap& map = exhibit.maps.front();
  MapCloudFigure figure;
  figure.cloud = exhibit.map_cloud.points_m;
  figure.path = track_of(map.source == "prior_run" ? exhibit.prior : exhibit.work);
  figure.stems = map.positions_m();
  figure.protocol = fmt::format("stand 0, {} points after thinning, {} stems by Algorithm 1",
                                figure.cloud.size(), figure.stems.size());
  return draw_map_cloud(folder, figure);
}

ReportFigure segmentation(const std::filesystem::path& folder, const LocalCloud& cloud,
                          const StemSettings& settings, std::int64_t frames) {
  const StemExtraction extraction = extract_stems(cloud, settings);
  SegmentationFigure figure;
  figure.original = cloud.points_m;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const PointStage stage = extraction.stages[i];
    (stage == PointStage::kDropped ? figure.removed : figure.kept).push_back(cloud.points_m[i]);
    if (stage == PointStage::kClustered) figure.clusters.push_back(cloud.points_m[i]);
  }
  figure.protocol =
      fmt::format("one window of {} key frames, {} stems", frames, extraction.stems.size());
  return draw_segmentation(folder, figure);
}

Edges edges_of(const DelaunayGraph& graph) {
  Edges edges;
  for (const DelaunayTriangle& triangle : graph.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(triangle.vertices[k]);
      const auto b = static_cast<std::size_t>(triangle.vertices[(k + 1) % 3]);
      if (a < b || triangle.neighbours[(k + 2) % 3] < 0) {
        edges.push_back({graph.vertices[a], graph.vertices[b]});
      }
    }
  }
  return edges;
}

struct StarPair {
  StarVertices local, map;
};

StarPair vertices_of(const StarMatch& match, const std::vector<Eigen::Vector2d>& local,
                     const std::vector<Eigen::Vector2d>& map) {
  StarPair pair;
  for (std::size_t i = 0; i < 6; ++i) {
    pair.local[i] = local[static_cast<std::size_t>(match.pairs[i].local)];
    pair.map[i] = map[static_cast<std::size_t>(match.pairs[i].map)];
  }
  return pair;
}

std::vector<ReportFigure> matching(const std::filesystem::path& folder, const LocalCloud& cloud,
                                   const Variant& variant, const std::string& window) {
  if (!variant.matcher) return {};
  std::vector<Eigen::Vector2d> local;
  for (const ObservedStem& stem : extract_stems(cloud, variant.stems).stems) {
    local.push_back(stem.position_m);
  }
  const LocateResult result = variant.matcher->locate(local);
  if (!result.accepted() || result.chosen < 0) return {};
  const auto map = variant.map->positions_m();
  MatchedStarsFigure stars;
  stars.local_edges = edges_of(build_delaunay(local));
  stars.map_edges = edges_of(variant.map->graph);
  for (const StarMatch& match : result.star_matches) {
    if (!match.agrees) continue;
    const StarPair pair = vertices_of(match, local, map);
    stars.local_stars.push_back(pair.local);
    stars.map_stars.push_back(pair.map);
  }
  const auto& chosen = result.star_matches[static_cast<std::size_t>(result.chosen)];
  const StarPair target = vertices_of(chosen, local, map);
  stars.target = target.local;
  stars.protocol =
      fmt::format("{}: {} of {} matching triangles agree", window, result.agreeing, result.matches);
  return {draw_matched_stars(folder, stars),
          draw_pairing(folder, {target.local, target.map, window + ", the chosen match"})};
}

/// The window in the middle of the drive, and its greatest number of frames up to 5: few enough
/// stars to follow by eye.
struct Exhibited {
  Window window;
  std::int64_t frames = 1;
};

Exhibited choose(const TrialExhibit& exhibit, const Scenario& scenario) {
  std::int64_t most = scenario.protocol.frames.front();
  for (const std::int64_t frames : scenario.protocol.frames) {
    if (frames <= 5) most = std::max(most, frames);
  }
  std::vector<Window> holding;
  for (const Window& window : exhibit.windows) {
    const auto& frames = window.frames;
    if (std::find(frames.begin(), frames.end(), most) != frames.end()) holding.push_back(window);
  }
  if (holding.empty()) return {exhibit.windows.front(), exhibit.windows.front().frames.front()};
  return {holding[holding.size() / 2], most};
}

}  // namespace

std::vector<ReportFigure> draw_exhibit(const std::filesystem::path& folder,
                                       const TrialExhibit& exhibit, const Scenario& scenario) {
  std::vector<ReportFigure> figures = {stand(folder, exhibit), map_cloud(folder, exhibit)};
  if (exhibit.windows.empty()) return figures;
  const auto [window, frames] = choose(exhibit, scenario);
  const LocalCloud cloud = window_cloud(exhibit.scans, window, frames, scenario.frame);
  figures.push_back(segmentation(folder, cloud, scenario.stems, frames));
  const std::string name = fmt::format("stand 0, window {}, {} key frames", window.number, frames);
  for (ReportFigure& figure : matching(folder, cloud, exhibit.variants.front(), name)) {
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace honka::eval
