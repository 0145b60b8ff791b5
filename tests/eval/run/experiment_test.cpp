#include "eval/run/experiment.h"

#include <catch2/catch.hpp>

#include "algo/types/user_error.h"
#include "eval/run/localization_tables.h"
#include "eval/run/paper_li2020.h"
#include "eval/run/progress.h"

using namespace honka;
using namespace honka::eval;

TEST_CASE("every experiment is found by its name and has help") {
  CHECK_FALSE(experiments().empty());
  for (const Experiment& experiment : experiments()) {
    ResolvedScenario resolved;
    resolved.scenario.experiment = experiment.name;
    CHECK(find_experiment(resolved).run == experiment.run);
    CHECK_FALSE(experiment.help.empty());
  }
}

TEST_CASE("an unknown experiment is named with its place and the known ones") {
  ResolvedScenario resolved;
  resolved.file = "my.toml";
  resolved.scenario.experiment = "localisation";
  CHECK_THROWS_WITH(find_experiment(resolved),
                    Catch::StartsWith("my.toml: ") && Catch::Contains("\"localisation\"") &&
                        Catch::Contains("did you mean \"localization\"") &&
                        Catch::Contains("it may be localization"));
  resolved.origins["experiment"] = "my.toml:3:1";
  CHECK_THROWS_WITH(find_experiment(resolved), Catch::StartsWith("my.toml:3:1: "));
  CHECK_THROWS_AS(find_experiment(resolved), UserError);
}

TEST_CASE("durations read as people say them") {
  CHECK(duration_text(0.0) == "0 s");
  CHECK(duration_text(11.6) == "12 s");
  CHECK(duration_text(59.4) == "59 s");
  CHECK(duration_text(59.6) == "1 min 00 s");
  CHECK(duration_text(200.0) == "3 min 20 s");
  CHECK(duration_text(3599.7) == "1 h 00 min");
  CHECK(duration_text(3900.0) == "1 h 05 min");
  CHECK(duration_text(90000.0) == "25 h 00 min");
}

TEST_CASE("the paper's rows are those of its Table 1") {
  struct Printed {
    std::int64_t frames;
    double trunks, matches, success;
  };
  for (const Printed& printed :
       {Printed{1, 54.09, 1.71, 0.2289}, Printed{3, 122.98, 4.97, 0.8879},
        Printed{5, 139.54, 10.22, 0.9928}, Printed{10, 133.96, 14.37, 1.0}}) {
    const auto row = paper_row(printed.frames);
    REQUIRE(row);
    CHECK(row->frames == printed.frames);
    CHECK(row->trunks == printed.trunks);
    CHECK(row->matching_triangles == printed.matches);
    CHECK(row->success_rate == printed.success);
  }
  CHECK_FALSE(paper_row(2));
}

TEST_CASE("the table of the paper shows paper, ours and n of N, other rows stand alone") {
  LocalizationSummary known, unknown;
  known.variant = unknown.variant = "default";
  known.map = unknown.map = "prior_run";
  known.frames = 1;
  known.windows = unknown.windows = 40;
  known.accepted = 12;
  known.successes = 10;
  unknown.frames = 2;
  LocalizationSummary other = known;
  other.variant = "same_run";
  const ReportTable table = paper_table({known, unknown, other}, "default", "Title", Scenario{});
  REQUIRE(table.rows.size() == 2);
  const auto& row = table.rows[0];
  REQUIRE(row.size() == table.headers.size());
  CHECK(row[0].text == "1");
  CHECK(row[1].paper == "54.1");
  CHECK(row[3].text == "25.0");
  CHECK(row[3].paper == "22.9");
  CHECK(row[5].text == "10 of 40");
  CHECK(row[6].text == "5.0");
  for (const ReportCell& cell : table.rows[1]) CHECK(cell.paper.empty());
  CHECK_THAT(table.protocol, Catch::Contains("map: prior_run"));
}

TEST_CASE("the JSON table keeps the paper beside the rows and its columns in order") {
  LocalizationSummary summary;
  summary.variant = "default";
  summary.map = "prior_run";
  summary.frames = 10;
  Scenario scenario;
  scenario.protocol.frames = {2, 10};
  const SummaryTable table = localization_json({summary}, scenario);
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0]["paper"]["time_ms"] == 600.0);
  CHECK(table.rows[0]["paper"]["matching_triangles"] == 14.37);
  CHECK(table.columns.front() == "frames");
  CHECK(table.paper["2"].is_null());
  CHECK(table.paper["10"]["success_rate"] == 1.0);
}
