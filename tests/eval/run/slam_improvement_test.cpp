#include <catch2/catch.hpp>
#include <cmath>

#include "algo/slam/chain.h"
#include "algo/types/random.h"
#include "eval/run/slam/progress_tables.h"
#include "eval/run/slam/selection_tables.h"

namespace honka::eval {
namespace {

/// A drive to and fro among 400 stems, and the drifting chain that the loop starts from.
ImprovementStart drive_to_and_fro(std::size_t count) {
  ImprovementStart start;
  start.seed = 3;
  SlamDrive& drive = start.drive;
  RandomStream stand(4, "improvement_stand");
  for (int k = 0; k < 400; ++k) {
    drive.true_stems_in_first_m.emplace_back(stand.uniform(-35.0, 35.0), stand.uniform(-35.0, 35.0),
                                             0.5);
  }
  for (std::size_t l = 0; l < count; ++l) {
    RandomStream random(4, "improvement_frame", {l});
    const double s = 2.0 * M_PI * static_cast<double>(l) / static_cast<double>(count);
    const Pose3 T_first_frame = pose_from_rpy({6.0 * std::sin(s), 3.0 * std::sin(2.0 * s), 0.0},
                                              0.0, 0.0, 0.4 * std::sin(s));
    drive.true_T_first_frame.push_back(T_first_frame);
    drive.times_s.push_back(static_cast<double>(l));
    SparseFrame frame{static_cast<std::int64_t>(l), {}};
    for (const Eigen::Vector3d& stem : drive.true_stems_in_first_m) {
      const Eigen::Vector3d point = T_first_frame.inverse() * stem;
      const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
      if (ViewCone{}.holds(point.head<2>())) frame.points_m.emplace_back(point + 0.05 * noise);
    }
    drive.frames.push_back(std::move(frame));
    const Pose3 drift = pose_from_rpy({0.01 * random.normal(), 0.0, 0.0}, 0.0, 0.0, 0.004);
    start.T_first_frame.push_back(l == 0
                                      ? Pose3::Identity()
                                      : Pose3(start.T_first_frame[l - 1] *
                                              between(drive.true_T_first_frame, l - 1, l) * drift));
  }
  return start;
}

SlamSettings improvement_settings() {
  SlamSettings settings;
  settings.loop.pairs.wanted = 100;
  settings.loop.pairs.tries = 1500;
  settings.loop.corrections = 8;
  settings.loop.rounds = 2;
  return settings;
}

/// A track whose figures are given, one point after another.
ProgressTrack track_of(const std::vector<double>& blurs, const std::vector<double>& noises,
                       const std::vector<double>& dimensions, const std::vector<double>& steps) {
  ProgressTrack track;
  track.side = "right";
  for (std::size_t k = 0; k < blurs.size(); ++k) {
    ProgressPoint point;
    point.round = k == 0 ? 0 : 1;
    point.applied = static_cast<std::int64_t>(k);
    point.map.blur = blurs[k];
    point.map.cluster_rmse_m = noises[k];
    point.map.dimension = dimensions[k];
    point.map.step_error_m = steps[k];
    track.points.push_back(point);
  }
  return track;
}

}  // namespace

TEST_CASE("progress: claims that hold, and the same claims broken") {
  const auto held = judge_claims({track_of({0.30, 0.10, 0.04, 0.05}, {0.5, 0.3, 0.15, 0.2},
                                           {1.4, 1.1, 0.5, 0.3}, {0.15, 0.15, 0.16, 0.155})});
  REQUIRE(held.size() == 4);
  for (const ProgressClaim& claim : held) {
    CAPTURE(claim.claim);
    CHECK(claim.trials == 1);
    CHECK(claim.held_in == 1);
    CHECK(claim.ours.find('{') == std::string::npos);
  }
  const auto broken = judge_claims({track_of({0.30, 0.10, 0.04, 0.04}, {0.1, 0.3, 0.5, 0.6},
                                             {1.2, 1.1, 0.9, 0.8}, {0.15, 0.15, 0.16, 0.2})});
  for (const ProgressClaim& claim : broken) {
    CAPTURE(claim.claim);
    CHECK(claim.held_in == 0);
  }
}

TEST_CASE("progress: rank correlation knows order, ties and too few") {
  const std::vector<double> any(4, 1.0);
  CHECK(rank_correlation(track_of({1, 2, 3, 9}, {5, 6, 7, 70}, any, any)) == Approx(1.0));
  CHECK(rank_correlation(track_of({1, 2, 3, 9}, {4, 3, 2, 1}, any, any)) == Approx(-1.0));
  CHECK(std::isnan(rank_correlation(track_of({1, 2}, {1, 2}, any, any))));
  CHECK(std::isnan(rank_correlation(track_of({1, 1, 1, 1}, {4, 3, 2, 1}, any, any))));
}

TEST_CASE("progress: each pair gives a point, and the map is measured as it is") {
  const ImprovementStart start = drive_to_and_fro(80);
  const SlamSettings settings = improvement_settings();
  for (const std::string side : {"right", "left"}) {
    CAPTURE(side);
    const ProgressTrack track =
        record_progress(start.drive, start.T_first_frame, settings, side, start.seed);
    CHECK(track.points.size() == static_cast<std::size_t>(track.points.back().tried) + 1);
    CHECK(track.points.back().round == 2);
    CHECK(track.points.back().applied > 0);
    for (const std::int64_t round : {0, 1, 2}) {
      CHECK(std::isfinite(track.end_of_round(round).map.cluster_rmse_m));
    }
    CHECK(track.floor.blur < track.points.front().map.blur);
    CHECK(track.floor.ate_m == Approx(0.0).margin(1e-9));
    CHECK(track.points.back().map.ate_m < track.points.front().map.ate_m);

    const auto map_m = map_points(start.drive.frames, start.T_first_frame);
    CHECK(track.points.front().map.blur == blur(map_m, settings.loop.blur));
    PaperLoopSettings loop = settings.loop;
    loop.side = side;
    const auto result =
        run_paper_loop(start.drive.frames, start.T_first_frame, settings.view, loop, start.seed);
    CHECK(track.points.back().map.blur == result.blur);
    CHECK(track.points.back().applied == result.applied);

    const Table points = progress_point_table({track});
    CHECK(points.rows() == track.points.size());
    CHECK(progress_json({track}).rows.size() == 3);
    CHECK(progress_table({track}).rows.size() == 4);  // and the floor
  }
}

TEST_CASE("progress: a drive without frames is an empty track") {
  const ProgressTrack track = record_progress({}, {}, improvement_settings(), "right", 1);
  CHECK(track.points.size() == 1);
  CHECK(std::isnan(track.points.front().map.blur));
  for (const ProgressClaim& claim : judge_claims({track})) CHECK(claim.trials == 0);
  CHECK(progress_json({track}).rows.size() == 1);
}

TEST_CASE("selection: what is found, chosen and right adds up") {
  const ImprovementStart start = drive_to_and_fro(80);
  const auto cases = run_selection(start, improvement_settings(), 0);
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].test == "nearest");
  CHECK(cases[1].test == "icp");
  for (const SelectionCase& c : cases) {
    CAPTURE(c.test);
    CHECK(!c.found.promising.empty());
    CHECK(c.promising_right <= static_cast<std::int64_t>(c.found.promising.size()));
    CHECK(c.inferior_right <= static_cast<std::int64_t>(c.found.inferior.size()));
    // At true poses only the noise of 0.05 m is left.
    CHECK(c.under_line_at_truth == c.judged());
    CHECK(c.choice.chosen.size() <= c.found.promising.size());
  }
  // An ICP mends what the chain has drifted.
  CHECK(static_cast<double>(cases[1].promising_right) / cases[1].found.promising.size() >
        static_cast<double>(cases[0].promising_right) / cases[0].found.promising.size());
  CHECK(selection_pair_table(cases).rows() ==
        static_cast<std::size_t>(cases[0].judged() + cases[1].judged()));
  CHECK(selection_json(cases).rows.size() == 2);
}

}  // namespace honka::eval
