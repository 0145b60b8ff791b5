// The odometry experiment and the judge of its tracks, as a user runs them.
#include "eval/io/table.h"
#include "eval/io/tum.h"
#include "tests/system/program.h"

namespace {

using honka::test::Json;
using honka::test::read_json;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;

/// Two small stands of bare stems, 15 m of driving.
std::string odometry_scenario() {
  return R"(experiment = "odometry"
title = "Tiny odometry"
trials = 1
forest.width_m = 60.0
forest.length_m = 60.0
forest.crown.branches = false
forest.crown.foliage = false
harvester.work_cycle = false
map.strip_road_spacing_m = 30.0
protocol.path_length_m = 15.0
stands.path_length_m = 12.0
stands.open.run = false
stands.thinned.run = false
stands.undergrowth_rich.run = false
stands.steep.run = false
)";
}

void check_odometry_row(const Json& row) {
  for (const std::string key :
       {"stand", "odometry", "drift_percent", "drift_deg_per_m", "real_time_factor", "lost"}) {
    CHECK(row.contains(key));
  }
  CHECK(row["drift_percent"].is_number());
  CHECK(row["real_time_factor"] > 0.0);
  const Json& sweeps = row["sweeps"];
  CHECK(sweeps["registered"].get<int>() + sweeps["degenerate"].get<int>() +
            sweeps["predicted"].get<int>() + sweeps["refused"].get<int>() >
        100);
}

}  // namespace

TEST_CASE(
    "honka run drives every stand with every odometry and leaves tracks that evaluate judges") {
  const TemporaryFolder folder;
  write_raw(folder / "tiny.toml", odometry_scenario());
  const auto outcome = run_honka({"run", "tiny.toml", "--out", "out"}, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Contains("Odometry by stand"));

  const Json summary = read_json(folder / "out/summary.json");
  const Json& rows = summary["tables"]["stands"]["rows"];
  REQUIRE(rows.size() == 4);
  for (const Json& row : rows) check_odometry_row(row);
  CHECK(rows[0]["stand"] == "default");
  CHECK(rows[2]["stand"] == "dense");
  const auto trials = honka::eval::read_table(folder / "out/trials.h5", "trials");
  const auto sweeps = honka::eval::read_table(folder / "out/trials.h5", "frames");
  CHECK(honka::eval::results_digest({&trials, &sweeps}) == summary["results_digest"]);
  for (const std::string figure : {"tracks_default.svg", "errors_dense.svg", "drift_loam.svg"}) {
    CHECK(std::filesystem::exists(folder / "out/figures" / figure));
  }

  const auto judged = run_honka({"evaluate", "out/default_truth.tum", "out/default_loam.tum",
                                 "--align", "yaw", "--delta", "1m", "--json"},
                                folder.path());
  REQUIRE(judged.exit_code == 0);
  const Json errors = Json::parse(judged.out);
  CHECK(errors["ape"]["translation_m"]["rmse"].get<double>() ==
        Approx(rows[0]["ape"]["translation_m"].get<double>()).epsilon(1e-9));
  CHECK(errors["rpe"]["translation_m"]["rmse"].get<double>() ==
        Approx(rows[0]["rpe_per_metre"]["translation_m"].get<double>()).epsilon(1e-9));
}

TEST_CASE("an odometry run without a stand, or of a trial that is not there, is refused") {
  const TemporaryFolder folder;
  write_raw(folder / "tiny.toml", odometry_scenario());
  honka::test::check_refused(run_honka({"run", "tiny.toml", "-s", "stands.default.run=false", "-s",
                                        "stands.dense.run=false"},
                                       folder.path()),
                             {"stands: none is to be driven", "stands.default.run"});
  honka::test::check_refused(run_honka({"run", "tiny.toml", "--trial", "1"}, folder.path()),
                             {"--trial 1", "0 to 0"});
}

TEST_CASE("evaluate draws its figures on request") {
  const TemporaryFolder folder;
  std::vector<honka::eval::TimedPose> truth, estimate;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.1 * i;
    truth.push_back({t, honka::pose_from_rpy({t, 0.1 * t * t, 0}, 0, 0, 0.1 * t)});
    estimate.push_back({t, honka::pose_from_rpy({t, 0.1 * t * t + 0.01 * t, 0}, 0, 0, 0.1 * t)});
  }
  honka::eval::write_tum(folder / "truth.tum", truth);
  honka::eval::write_tum(folder / "estimate.tum", estimate);
  const std::vector<std::string> plain = {"evaluate", "truth.tum", "estimate.tum", "--json"};
  std::vector<std::string> plotted = plain;
  plotted.insert(plotted.end(), {"--plot", "plots"});
  const auto outcome = run_honka(plotted, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out == run_honka(plain, folder.path()).out);
  for (const std::string name : {"trajectory", "ape", "rpe"}) {
    CAPTURE(name);
    CHECK_THAT(read_text(folder / ("plots/" + name + ".svg")), Catch::Contains("</svg>"));
    CHECK(std::filesystem::exists(folder / ("plots/" + name + ".gp")));
    CHECK(std::filesystem::exists(folder / ("plots/" + name + ".dat")));
  }
}
