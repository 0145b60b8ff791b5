// honka run on stem lists without rays, and on pairs, as a user runs them.
#include <cmath>
#include <fstream>

#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::read_json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr const char* kTinyLists = R"(experiment = "sighting"
trials = 2
[forest.spacing]
strauss.sweeps = 5
[variants]
methods = "li2020, consensus"
[sighting]
queries = 12
li2020_queries = 6
[sighting.map]
stems = 500
[sighting.cases]
noise_m = [0.01, 0.15]
missed_share = [0.0, 0.3]
)";

void write_scenario(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text) {
  std::ofstream(folder / name) << text;
}

}  // namespace

TEST_CASE("a run on lists leaves tables, figures and a report, threads do not change its digest") {
  const TemporaryFolder folder;
  write_scenario(folder, "lists.toml", kTinyLists);
  for (const char* threads : {"1", "2"}) {
    const auto outcome = run_honka(
        {"run", "lists.toml", "--threads", threads, "--out", std::string("out") + threads},
        folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("noise 0.15 m, 30 % missed"));
  }
  const Json one = read_json(folder / "out1/summary.json");
  const Json two = read_json(folder / "out2/summary.json");
  CHECK(one["results_digest"] == two["results_digest"]);
  const Json rows = one["tables"]["lists"]["rows"];
  REQUIRE(rows.size() == 4);
  for (const Json& row : rows) {
    for (const char* key :
         {"case", "method", "frames", "stems_in_map", "queries", "success_rate", "success_interval",
          "wrong_rate", "refused_rate", "error_over_bound", "time_ms"}) {
      CHECK(row.contains(key));
    }
    CHECK(row["queries"] == (row["method"] == "li2020" ? 6 : 12));
    CHECK(row["time_ms"].contains("p50"));
  }
  for (const char* file : {"report.html", "trials.h5", "figures/success_by_case.gp",
                           "figures/bound_by_case.gp", "figures/time_by_case.gp"}) {
    CHECK(fs::exists(folder / "out1" / file));
  }
}

TEST_CASE("one trial alone, and what a user mistypes") {
  const TemporaryFolder folder;
  write_scenario(folder, "lists.toml", kTinyLists);
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"run", "lists.toml", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_honka(arguments, folder.path());
  };
  REQUIRE(run({"--trial", "1"}).exit_code == 0);
  const Json summary = read_json(folder / "out/summary.json");
  for (const Json& row : summary["tables"]["lists"]["rows"]) {
    CHECK(row["queries"] == (row["method"] == "li2020" ? 3 : 6));
  }
  check_refused(run({"--trial", "2"}), {"--trial 2", "0 to 1"});
  check_refused(run({"-s", "variants.methods=li2020, stars"}), {"variants.methods", "stars"});
  check_refused(run({"-s", "sighting.border_m=900"}), {"sighting.border_m"});
  check_refused(run({"-s", "sighting.cases.noise_m=[0.1]"}), {"sighting.cases"});
}

TEST_CASE("pairs that are not there are told with the remedy") {
  const TemporaryFolder folder;
  write_scenario(folder, "pairs.toml", "experiment = \"stem_pairs\"\n");
  check_refused(run_honka({"run", "pairs.toml", "-s", "pairs.folder=nowhere"}, folder.path()),
                {"pairs.folder", "nowhere", "-s pairs.folder=FOLDER"});
}

TEST_CASE("the real pairs: every wrong combination refused, every pair of consensus found") {
  const auto pairs = honka::test::shared("data/paired_stem_maps");
  if (!fs::exists(pairs)) {
    WARN("skipped: " << pairs << " is absent");
    return;
  }
  const TemporaryFolder folder;
  const auto outcome = run_honka({"run", HONKA_SOURCE_DIR "/scenarios/localization/real_pairs.toml",
                                  "-s", "pairs.folder=" + pairs.string(), "--out", "out"},
                                 folder.path());
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json summary = read_json(folder / "out/summary.json");
  for (const Json& row : summary["tables"]["real_pairs"]["rows"]) {
    CAPTURE(row.dump());
    CHECK(row["wrong"] == 0);
    CHECK(row["queries"] == (row["case"] == "pairs" ? 6 : 30));
    if (row["method"] == "consensus" && row["case"] == "pairs") CHECK(row["successes"] == 6);
  }
}
