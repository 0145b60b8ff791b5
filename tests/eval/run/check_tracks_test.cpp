// Trajectories: which truth belongs to an estimate, and errors known on paper.
#include <catch2/catch.hpp>
#include <cmath>

#include "eval/io/tum.h"
#include "eval/run/check/track_figures.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;

namespace {

/// A quarter of a circle of 10 m, turned and moved as a whole, with every other pose off by
/// `sideways_m` in z.
std::vector<TimedPose> bend(double yaw_rad, double sideways_m, std::size_t poses = 401) {
  std::vector<TimedPose> track;
  for (std::size_t i = 0; i < poses; ++i) {
    const double angle = 0.5 * M_PI * static_cast<double>(i) / static_cast<double>(poses - 1);
    Pose3 pose = Pose3::Identity();
    pose.translation() << 10.0 * std::cos(angle), 10.0 * std::sin(angle),
        (i / 2 % 2 == 0 ? 1.0 : -1.0) * sideways_m;
    const Pose3 turn(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
    track.push_back({0.1 * static_cast<double>(i), turn * pose});
  }
  return track;
}

double number_at(const std::vector<CheckFigure>& figures, const std::string& column) {
  for (const CheckFigure& figure : figures) {
    if (figure.column == column && figure.number) return *figure.number;
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("check: a truth is found for each estimate beside it") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "tracks");
  for (const char* name :
       {"stand_0_work", "stand_0_work_truth", "open_loam", "open_truth", "open_loam_trial1",
        "open_truth_trial1", "tracks/trial_0_edge", "tracks/trial_0_truth", "tracks/lonely",
        "a_b_truth", "a_b_x", "a_truth"}) {
    write_tum(folder / (std::string(name) + ".tum"), bend(0.0, 0.0, 3));
  }
  const std::vector<TrackFiles> expected = {
      {"a_b_truth.tum", "a_b_x.tum"},
      {"open_truth.tum", "open_loam.tum"},
      {"open_truth_trial1.tum", "open_loam_trial1.tum"},
      {"stand_0_work_truth.tum", "stand_0_work.tum"},
      {"tracks/trial_0_truth.tum", "tracks/trial_0_edge.tum"}};
  CHECK(tracks_with_truth(folder.path()) == expected);
}

TEST_CASE("check: an estimate's errors are those known on paper, its own frame aside") {
  const TemporaryFolder run, references;
  write_tum(run / "a_truth.tum", bend(0.0, 0.0));
  write_tum(run / "a.tum", bend(1.0, 0.2));
  const auto accepted = accept_tracks(run.path(), references.path(), "small/run");
  REQUIRE(accepted.size() == 4);
  CHECK(accepted[0].table == kTrajectoryTable);
  CHECK(accepted[0].row == "truth=trajectories/small/run/a_truth.tum; estimate=a.tum; align=yaw");
  // Every second pose of 401 is stored: 0.2 m above and below in turn.
  CHECK(read_tum(references / "trajectories/small/run/a_truth.tum").size() == 201);
  CHECK(number_at(accepted, "ape_m") == Approx(0.2).epsilon(1e-3));
  CHECK(number_at(accepted, "ape_deg") == Approx(0.0).margin(1e-3));
  CHECK(number_at(accepted, "rpe_m") == Approx(0.4).epsilon(1e-3));
  CHECK(accepted[0].tolerance == Approx(0.05).epsilon(1e-3));

  SECTION("judged again they are the same, and an estimate that strays shows") {
    CHECK((track_figures(accepted, run.path(), references.path()) == accepted));
    write_tum(run / "a.tum", bend(1.0, 0.3));
    const auto worse = track_figures(accepted, run.path(), references.path());
    CHECK(number_at(worse, "ape_m") == Approx(0.3).epsilon(1e-3));
  }
  SECTION("an estimate that is gone gives no figures; rows must name both files") {
    std::filesystem::remove(run / "a.tum");
    CHECK(track_figures(accepted, run.path(), references.path()).empty());
    auto broken = accepted;
    broken[0].row = "estimate=a.tum";
    CHECK_THAT(user_error_of([&] { (void)track_figures(broken, run.path(), references.path()); }),
               Catch::Contains("no truth="));
  }
}

TEST_CASE("check: an estimate that never leaves its place has no errors to compare") {
  const TemporaryFolder run, references;
  auto still = bend(0.0, 0.0, 10);
  for (TimedPose& pose : still) pose.pose = Pose3::Identity();
  write_tum(run / "a_truth.tum", bend(0.0, 0.0, 10));
  write_tum(run / "a.tum", still);
  CHECK(accept_tracks(run.path(), references.path(), "x").empty());
}
