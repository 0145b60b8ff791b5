#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "eval/io/safe_file.h"
#include "eval/report/figure_accuracy.h"
#include "eval/report/figure_errors.h"
#include "eval/report/figure_map_cloud.h"
#include "eval/report/figure_matched_stars.h"
#include "eval/report/figure_segmentation.h"
#include "eval/report/figure_stand.h"
#include "eval/report/figure_stem_recall.h"
#include "eval/report/figure_success.h"
#include "eval/report/figure_trunks.h"
#include "eval/report/gnuplot.h"
#include "tests/eval/report/figure_folder.h"
#include "tests/eval/report/synthetic_stand.h"

using namespace honka;
using namespace honka::eval;
using honka::test::check_drawn;
using honka::test::FigureFolder;
using honka::test::synthetic_cloud;
using honka::test::synthetic_graph;
using honka::test::synthetic_stand;

namespace {

constexpr std::array<std::int64_t, 4> kFrames = {1, 3, 5, 10};
constexpr std::array<double, 4> kPaperTrunks = {54.09, 122.98, 139.54, 133.96};
constexpr std::array<double, 4> kPaperMatches = {1.71, 4.97, 10.22, 14.37};
const std::string kProtocol = "synthetic input, 210 windows, 3 stands, tolerance 4.5 m²";

WindowCountsFigure counts(const std::array<double, 4>& means) {
  WindowCountsFigure figure;
  for (std::size_t i = 0; i < kFrames.size(); ++i) {
    RandomStream random(1, "counts", {i});
    WindowCounts series{kFrames[i], {}, means[i]};
    for (int window = 0; window < 210; ++window) {
      series.counts.push_back(static_cast<double>(random.poisson(0.95 * means[i])));
    }
    figure.series.push_back(series);
  }
  figure.protocol = kProtocol;
  return figure;
}

}  // namespace

TEST_CASE("figures: map cloud, Figure 1c") {
  const FigureFolder folder;
  MapCloudFigure input;
  const StemMap stand = synthetic_stand(300.0, 200.0, 2200);
  input.cloud = synthetic_cloud(stand, 60);
  for (const Stem& stem : stand) {
    if (std::abs(stem.position_m.y() - 100.0) < 60.0) input.stems.push_back(stem.position_m);
  }
  for (int i = 0; i <= 300; ++i) input.path.emplace_back(i, 100.0 + 4.0 * std::sin(0.05 * i));
  input.protocol = "returns within 40 m, voxel 2.5 cm, map of a prior run";
  check_drawn(folder, draw_map_cloud(folder.path(), input), "map_cloud", "png");
}

TEST_CASE("figures: segmentation, Figure 5") {
  const FigureFolder folder;
  SegmentationFigure input;
  const StemMap stand = synthetic_stand(80.0, 60.0, 180);
  for (Eigen::Vector3d point : synthetic_cloud(stand, 220)) {
    const bool ground = point.z()<0.4, crown = point.z()> 9.0;
    point -= Eigen::Vector3d(40.0, 30.0, 3.0);
    input.original.push_back(point);
    (ground || crown ? input.removed : input.kept).push_back(point);
    if (!ground && !crown && point.x() < 30.0) input.clusters.push_back(point);
  }
  input.protocol = "C10, d_threshold 0.3 m, clusters of at least 5 points";
  check_drawn(folder, draw_segmentation(folder.path(), input), "segmentation", "png");
}

TEST_CASE("figures: matched stars and pairing, Figures 6 and 7") {
  const FigureFolder folder;
  const auto graph = synthetic_graph();
  MatchedStarsFigure input;
  const Eigen::Rotation2Dd R(0.7);
  const auto in_map = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return R * p + Eigen::Vector2d(120.0, 80.0);
  };
  input.local_edges = graph.edges;
  for (const auto& edge : graph.edges)
    input.map_edges.push_back({in_map(edge[0]), in_map(edge[1])});
  RandomStream random(3, "stars", {});
  for (std::size_t i = 0; i < graph.stars.size(); i += graph.stars.size() / 11) {
    StarVertices partner;
    for (std::size_t k = 0; k < partner.size(); ++k) {
      partner[k] =
          in_map(graph.stars[i][k]) + 0.15 * Eigen::Vector2d(random.normal(), random.normal());
    }
    input.local_stars.push_back(graph.stars[i]);
    input.map_stars.push_back(partner);
  }
  input.target = input.local_stars[4];
  input.protocol = "C10, window 17, 13 matches, 12 agree";
  check_drawn(folder, draw_matched_stars(folder.path(), input), "matched_stars", "svg");
  const PairingFigure pair{input.local_stars[4], input.map_stars[4], "C10, residual 0.11 m"};
  check_drawn(folder, draw_pairing(folder.path(), pair), "pairing", "svg");
}

TEST_CASE("figures: counts per window, Figures 8 and 9") {
  const FigureFolder folder;
  check_drawn(folder, draw_trunks(folder.path(), counts(kPaperTrunks)), "trunks", "svg");
  check_drawn(folder, draw_matches(folder.path(), counts(kPaperMatches)), "matches", "svg");
}

TEST_CASE("figures: accuracy, Figure 10, and the distribution of errors") {
  const FigureFolder folder;
  AccuracyFigure accuracy;
  ErrorsFigure errors;
  for (std::size_t i = 0; i < kFrames.size(); ++i) {
    RandomStream random(5, "accuracy", {i});
    AccuracySeries series{kFrames[i], {}, {}, {}};
    ErrorSeries error{kFrames[i], {}, {}};
    const double scale = 0.8 / std::sqrt(static_cast<double>(kFrames[i]));
    for (int window = 0; window < 200; ++window) {
      series.rotation_error_deg.push_back(scale * std::abs(random.normal()));
      series.match_time_s.push_back(0.002 * std::exp(0.3 * random.normal() + 0.1 * double(i)));
      series.map_time_s.push_back(0.008 * double(kFrames[i]) * std::exp(0.1 * random.normal()));
      error.to_truth_m.push_back(0.3 * scale * std::hypot(random.normal(), random.normal()));
      error.to_odometry_m.push_back(0.2 * scale * std::hypot(random.normal(), random.normal()));
    }
    error.to_truth_m[3] = std::numeric_limits<double>::quiet_NaN();
    accuracy.series.push_back(series);
    errors.series.push_back(error);
  }
  accuracy.protocol = errors.protocol = kProtocol;
  check_drawn(folder, draw_accuracy(folder.path(), accuracy), "accuracy", "svg");
  check_drawn(folder, draw_errors(folder.path(), errors), "errors", "svg");
}

TEST_CASE("figures: success and speed") {
  const FigureFolder folder;
  SuccessFigure success{
      {{"map of a prior run",
        {{1, .24, .19, .30}, {3, .91, .86, .94}, {5, 1., .98, 1.}, {10, 1., .98, 1.}}},
       {"map of the same run",
        {{1, .43, .36, .50}, {3, .97, .94, .99}, {5, 1., .98, 1.}, {10, 1., .98, 1.}}}},
      {{1, .2289}, {3, .8879}, {5, .9928}, {10, 1.0}},
      "at least 3 agreeing matches, within 0.5 m and 2.5°; n = 210 of 210"};
  check_drawn(folder, draw_success(folder.path(), success), "success", "svg");
  SpeedFigure speed;
  for (const char* map : {"prior run", "same run"}) {
    for (const std::int64_t frames : kFrames) {
      speed.rows.push_back({frames_label(frames) + ", " + map, 20.0 / double(frames)});
    }
  }
  speed.protocol = "p95 of the time of one localization, one core";
  check_drawn(folder, draw_speed(folder.path(), speed), "speed", "svg");
}

TEST_CASE("figures: stem recall and the stand") {
  const FigureFolder folder;
  StemRecallFigure recall;
  for (std::size_t i = 0; i < kFrames.size(); ++i) {
    StemRecallSeries series{frames_label(kFrames[i]), {}};
    for (double low = 0.0; low < 50.0; low += 5.0) {
      const double far = std::max(0.0, low - 10.0 - 4.0 * double(i));
      series.bins.push_back({low, low + 5.0, std::exp(-0.002 * far * far), 1.0 - 0.002 * low});
    }
    recall.series.push_back(series);
  }
  recall.protocol = kProtocol;
  check_drawn(folder, draw_stem_recall(folder.path(), recall), "stem_recall", "svg");
  StandFigure stand{synthetic_stand(300.0, 200.0, 2200), {}, {}, {}, "default scene, seed 1"};
  for (const double y : {25.0, 75.0, 125.0, 175.0}) stand.roads.push_back({{0, y}, {300, y}});
  for (int x = 50; x <= 250; x += 2) {
    stand.work_path.emplace_back(x, 75.0);
    if (x % 6 == 0) stand.window_starts.emplace_back(x, 75.0);
  }
  check_drawn(folder, draw_stand(folder.path(), stand), "stand", "png");
}

TEST_CASE("figures: no data gives a notice and no file") {
  const FigureFolder folder;
  const ReportFigure errors = draw_errors(folder.path(), {});
  CHECK(errors.file.empty());
  CHECK(errors.notice.find("no data") != std::string::npos);
  CHECK(draw_map_cloud(folder.path(), {}).file.empty());
  CHECK(draw_trunks(folder.path(), {}).file.empty());
  CHECK(draw_accuracy(folder.path(), {{{1, {}, {}, {}}}, "none accepted"}).file.empty());
  CHECK(draw_success(folder.path(), {}).file.empty());
  CHECK(draw_speed(folder.path(), {}).file.empty());
}

TEST_CASE("figures: without gnuplot a notice names the package") {
  const FigureFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const ReportFigure figure = draw_trunks(folder.path(), counts(kPaperTrunks));
  ::setenv("PATH", path.c_str(), 1);
  CHECK(figure.file.empty());
  CHECK(figure.notice.find("gnuplot-nox") != std::string::npos);
  CHECK(std::filesystem::exists(folder.path() / "trunks.gp"));
}
