// The figures of Nevalainen et al. 2021 that need no simulator, and the study of ICP's starts.
#include <unistd.h>

#include <catch2/catch.hpp>

#include "algo/slam/view_cone.h"
#include "algo/types/random.h"
#include "eval/report/summary.h"
#include "eval/run/slam/convergence_study.h"
#include "eval/run/slam/figure_results.h"
#include "eval/run/slam/overlap_experiment.h"
#include "eval/run/slam/power_experiment.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

RunRequest figure_request(const std::string& scenario, const fs::path& out) {
  RunRequest request;
  request.resolved = load_scenario(fs::path(HONKA_SOURCE_DIR) / "scenarios" / "nevalainen2021" /
                                   (scenario + ".toml"));
  request.out = out;
  request.command = "honka run";
  return request;
}

fs::path figure_folder() {
  return fs::temp_directory_path() / ("honka_slam_figures_" + std::to_string(::getpid()));
}

double fact_of(const SummaryTable& table, const std::string& beginning) {
  for (const Json& row : table.rows) {
    if (row["quantity"].get<std::string>().rfind(beginning, 0) == 0) {
      return row["value"].get<double>();
    }
  }
  FAIL("no quantity begins with " << beginning);
  return 0.0;
}

/// Key frames a metre apart on a straight road through stems at random, without noise.
SlamDrive stem_row_drive(std::size_t frames) {
  SlamDrive drive;
  RandomStream random(3, "stem_row_stems");
  std::vector<Eigen::Vector3d> stems;
  for (int k = 0; k < 500; ++k) {
    stems.emplace_back(random.uniform(-40.0, 70.0), random.uniform(-40.0, 40.0),
                       random.normal(0.0, 0.5));
  }
  for (std::size_t l = 0; l < frames; ++l) {
    const Pose3 pose(Eigen::Translation3d(static_cast<double>(l), 0.0, 0.0));
    SparseFrame frame{static_cast<std::int64_t>(l), {}};
    for (const Eigen::Vector3d& stem : stems) {
      const Eigen::Vector3d point = pose.inverse() * stem;
      if (ViewCone{}.holds(point.head<2>())) frame.points_m.push_back(point);
    }
    drive.frames.push_back(frame);
    drive.true_T_first_frame.push_back(pose);
  }
  return drive;
}

}  // namespace

TEST_CASE("The experiments of powers and overlap write their folders, with the same digits twice") {
  const fs::path out = figure_folder();
  for (const auto& [scenario, run] : std::vector<std::pair<std::string, RunExperiment>>{
           {"fig2_fig3", run_power_experiment}, {"fig8", run_overlap_experiment}}) {
    const RunOutcome first = run(figure_request(scenario, out));
    const RunOutcome again = run(figure_request(scenario, out));
    CHECK(first.digest == again.digest);
    CHECK(fs::exists(out / "report.html"));
    const Summary summary = read_summary(out / "summary.json");
    CHECK(summary.report.figures.size() == 2);
    if (scenario == "fig8") {
      CHECK(fact_of(summary.tables.at("overlap"), "error of 256 samples, RMS") < 0.01);
      continue;
    }
    const SummaryTable& powers = summary.tables.at("powers");
    CHECK(fact_of(powers, "power, then inverse") < 1e-14);
    CHECK(fact_of(powers, "power 1/n") < 1e-13);
    CHECK(powers.rows[1]["paper"]["value"] == 4.8e-3);
  }
  fs::remove_all(out);
}

TEST_CASE("ICP's starts: right ones succeed, hopeless ones fail, on any number of threads") {
  const SlamDrive drive = stem_row_drive(25);
  const auto pairs = draw_convergence_pairs(drive, 12, 1);
  REQUIRE(pairs.size() == 12);
  for (const ConvergencePair& pair : pairs) {
    CHECK(pair.target < pair.source);
    CHECK(pair.overlap >= 0.4);
    CHECK(pair.T_target_source.translation().x() == Approx(double(pair.source - pair.target)));
  }
  const std::vector<StartError> starts = {{0.0, 0.0, 0.0}, {0.3, 1.0, 0.0}, {6.0, 25.0, 0.0}};
  const auto points = study_convergence(drive, pairs, starts, 1, 1);
  CHECK(points[0].success == 1.0);
  CHECK(points[0].error_m < 1e-9);
  CHECK(points[0].starts == 48);
  CHECK(points[1].success > 0.9);
  CHECK(points[2].success < 0.3);
  const auto threaded = study_convergence(drive, pairs, starts, 1, 2);
  for (std::size_t k = 0; k < starts.size(); ++k) {
    CHECK(threaded[k].error_m == points[k].error_m);
    CHECK(threaded[k].success == points[k].success);
  }
}

TEST_CASE("A drive of too few frames gives no pairs") {
  CHECK(draw_convergence_pairs(SlamDrive{}, 10, 1).empty());
  CHECK(draw_convergence_pairs(stem_row_drive(1), 10, 1).empty());
}

TEST_CASE("Starts on an ellipse end on its half axes") {
  const auto starts = starts_on_ellipse(1.75, 4.53);
  CHECK(starts.front().shift_m == Approx(1.75));
  CHECK(starts.front().turn_deg == Approx(0.0).margin(1e-12));
  CHECK(starts.back().turn_deg == Approx(4.53));
  for (const StartError& start : starts) {
    CHECK(std::pow(start.shift_m / 1.75, 2) + std::pow(start.turn_deg / 4.53, 2) == Approx(1.0));
  }
}

}  // namespace honka::eval
