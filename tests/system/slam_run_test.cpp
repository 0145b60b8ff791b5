// The SLAM experiment as a user runs it, on a road of a few metres.
#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::test::Json;
using honka::test::read_json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;

std::string slam_scenario() {
  return R"(experiment = "slam"
title = "Tiny SLAM"
trials = 2
forest.width_m = 40.0
forest.length_m = 30.0
forest.margin_m = 20.0
forest.density_per_ha = 940.0
forest.crown.branches = false
forest.crown.foliage = false
harvester.least_hop_m = 5.0
harvester.most_hop_m = 5.0
harvester.stems_per_stop = 1
harvester.process_s = 0.0
harvester.most_swing_deg = 30.0
protocol.path_length_m = 5.0
odometry.source = "stems"
stems.height_band = true
stems.centre = "bias_corrected"
slam.study = "table1"
slam.chain.inlier_ratio = 0.4
)";
}

}  // namespace

TEST_CASE("honka run of the SLAM experiment leaves Table 1, tracks that evaluate judges, figures") {
  const TemporaryFolder folder;
  write_raw(folder / "tiny.toml", slam_scenario());
  const auto outcome = run_honka({"run", "tiny.toml", "--out", "out"}, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Contains("Table 1"));

  const Json summary = read_json(folder / "out/summary.json");
  const Json& rows = summary["tables"]["table1"]["rows"];
  REQUIRE(rows.size() == 12);
  for (const Json& row : rows) {
    for (const std::string key : {"start", "order", "blur", "blur_floor", "cluster_rmse_m",
                                  "cluster_rmse_floor_m", "ate_m", "corrections", "go_icp_calls"}) {
      CHECK(row.contains(key));
    }
    CHECK(row["seeds"] == 2);
    CHECK(row["blur_interval"].size() == 2);
  }
  CHECK(summary["tables"]["table1"]["paper"]["medium_gaps_first"]["blur"] == 0.022);
  const auto runs = honka::eval::read_table(folder / "out/trials.h5", "trials");
  const auto frames = honka::eval::read_table(folder / "out/trials.h5", "frames");
  CHECK(runs.rows() == 24);
  CHECK(honka::eval::results_digest({&runs, &frames}) == summary["results_digest"]);
  for (const std::string figure : {"fig11.png", "blur.svg", "paths.svg"}) {
    CHECK(std::filesystem::exists(folder / "out/figures" / figure));
  }

  const auto judged =
      run_honka({"evaluate", "out/tracks/trial_0_truth.tum",
                 "out/tracks/trial_0_reregistered_none.tum", "--align", "se3", "--json"},
                folder.path());
  INFO(judged.err);
  REQUIRE(judged.exit_code == 0);
  const Json errors = Json::parse(judged.out);
  CHECK(runs.strings("start")[8] == "reregistered");
  CHECK(errors["ape"]["translation_m"]["rmse"].get<double>() ==
        Approx(runs.doubles("ate_m")[8]).epsilon(1e-9));
}

TEST_CASE("the methods stand in one table, a study or a trial that is not there is refused") {
  const TemporaryFolder folder;
  write_raw(folder / "tiny.toml", slam_scenario());
  const auto outcome =
      run_honka({"run", "tiny.toml", "--out", "out", "--trial", "1", "-s", "slam.study=methods"},
                folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json summary = read_json(folder / "out/summary.json");
  const Json& rows = summary["tables"]["methods"]["rows"];
  REQUIRE(rows.size() == 10);
  CHECK(rows[0]["start"] == "edge");
  CHECK(rows[9]["start"] == "true_poses");
  honka::test::check_refused(run_honka({"run", "tiny.toml", "--trial", "2"}, folder.path()),
                             {"--trial 2", "0 to 1"});
  honka::test::check_refused(
      run_honka({"run", "tiny.toml", "-s", "slam.study=table9"}, folder.path()), {"table1"});
}
