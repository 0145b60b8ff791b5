#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/user_error.h"
#include "eval/run/slam/link_experiment.h"
#include "eval/run/slam/link_figures.h"
#include "eval/run/slam/link_tables.h"
#include "tests/eval/run/link_drive.h"

namespace honka::eval {
namespace {

/// A study of few links, one of which loses everything.
Scenario small_link_study() {
  Scenario scenario;
  scenario.link.bandwidth_shares = {1.0, 0.1};
  scenario.link.losses = {0.0, 1.0};
  scenario.link.delays_s = {0.0, 60.0};
  scenario.link.methods = "chain, pose_graph";
  scenario.link.edge_poses = "odometry";
  scenario.link.radio.delay_s = 0.0;
  return scenario;
}

const LinkRow& row_of(const LinkTrial& trial, const std::string& series, double value,
                      const std::string& method) {
  for (const LinkRow& row : trial.rows) {
    if (row.link.series == series && row.link.value == value && row.method == method) return row;
  }
  throw std::runtime_error("no such row");
}

}  // namespace

TEST_CASE("every link of a study gets a row a method, also one that loses everything") {
  const SlamDrive drive = straight_drive(50);
  const LinkTrial trial = study_links(drive, small_link_study(), 0, 1);
  REQUIRE(trial.rows.size() == (2 * 3 + 2 * 2 + 2) * 2);
  for (const char* method : {"chain", "pose_graph"}) {
    const LinkRow& perfect = row_of(trial, "loss", 0.0, method);
    CHECK(perfect.status == "mapped");
    // The last message may still be on its way when the drive ends.
    CHECK(perfect.tally.arrived >= 49);
    CHECK(perfect.tally.arrived + perfect.tally.late == 50);
    // True poses through a message: a millimetre and the turn's rounding, and centimetre stems.
    CHECK(perfect.quality.ate_m < 0.02);
    CHECK(perfect.quality.stems_mapped == perfect.floor.stems_mapped);

    const LinkRow& lost = row_of(trial, "loss", 1.0, method);
    CHECK(lost.status == "nothing_received");
    CHECK(std::isnan(lost.quality.ate_m));
    CHECK(std::isnan(lost.floor.blur));
    CHECK(lost.quality.stems_mapped == 0);
  }
  // 25 s of driving, 60 s of delay: nothing has arrived when the drive ends.
  CHECK(row_of(trial, "delay", 60.0, "chain").status == "nothing_received");
  CHECK(row_of(trial, "delay", 60.0, "chain").tally.late == 50);

  const auto scores = link_scores({trial, trial});
  REQUIRE(scores.size() == trial.rows.size());
  CHECK(scores.front().trials.size() == 2);
  const ReportTable table = link_series_table("loss", scores);
  REQUIRE(table.rows.size() == 2 * 2 * 2);
  for (const auto& row : table.rows) CHECK(row.size() == table.headers.size());
  for (const auto& row : link_series_table("delay", scores).rows) {
    CHECK(row.size() == link_series_table("delay", scores).headers.size());
  }
  CHECK(table.rows.back()[7].text == "nothing_received");
  CHECK(link_series_json("loss", scores).rows.back()["mapped"] == 0);
  CHECK(link_series_json("loss", scores).rows.back()["ate_m"].is_null());
  Table rows = link_trial_table();
  append_link_rows(rows, trial);
  CHECK(rows.rows() == trial.rows.size());
}

TEST_CASE("a study has the same digits on any number of threads") {
  const SlamDrive drive = straight_drive(30);
  const auto digest = [&](int threads) {
    Table rows = link_trial_table();
    append_link_rows(rows, study_links(drive, small_link_study(), 1, threads));
    return results_digest({&rows});
  };
  CHECK(digest(1) == digest(3));
}

TEST_CASE("methods of the cloud are words with commas between") {
  LinkStudySettings settings;
  CHECK(settings.method_list() == std::vector<std::string>{"chain", "pose_graph"});
  settings.methods = " paper,,landmark_ba ";
  CHECK(settings.method_list() == std::vector<std::string>{"paper", "landmark_ba"});
  settings.methods = ", ";
  CHECK(settings.method_list().empty());
}

TEST_CASE("an unknown method of the cloud is the user's mistake, said before the drive") {
  RunRequest request;
  request.resolved.file = "bandwidth.toml";
  request.resolved.scenario.link.methods = "chain, posegraph";
  CHECK_THROWS_WITH(run_link_experiment(request),
                    Catch::Contains("bandwidth.toml: link.study.methods: \"posegraph\""));
  request.resolved.scenario.link.methods = "";
  CHECK_THROWS_AS(run_link_experiment(request), UserError);
}

}  // namespace honka::eval
