// honka check: results against references, the acceptance of new ones, and what bad input gets.
#include <algorithm>
#include <fstream>

#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::read_json;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;

const std::string kScenario = "scenarios/own/lists.toml";
const std::string kSummary = "results/own/lists/summary.json";
const std::string kReference = "results/reference/own/lists.csv";

/// 40 stem lists in a map of 200 stems: a fraction of a second.
void write_lists(const TemporaryFolder& folder, const std::string& more = "") {
  std::filesystem::create_directories(folder / "scenarios/own");
  write_raw(folder / kScenario, R"(experiment = "sighting"
trials = 1
forest.density_per_ha = 367.0
variants.methods = "consensus"
sighting.queries = 40
sighting.noise_m = 0.1
sighting.map.stems = 200
)" + more);
}

void change_summary(const TemporaryFolder& folder, const std::function<void(Json&)>& change) {
  Json summary = read_json(folder / kSummary);
  change(summary);
  write_raw(folder / kSummary, summary.dump(2));
}

/// Results as a honka without uncommitted changes would leave them.
void make_clean(const TemporaryFolder& folder) {
  change_summary(folder, [](Json& summary) {
    summary["context"]["dirty"] = "false";
    summary["context"]["commit"] = "0123456789";
  });
}

void run_lists(const TemporaryFolder& folder, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"run", kScenario});
  REQUIRE(run_honka(more, folder.path()).exit_code == 0);
  make_clean(folder);
}

void accept_lists(const TemporaryFolder& folder) {
  write_lists(folder);
  run_lists(folder);
  const auto accepted =
      run_honka({"check", "--accept", "own/lists", "--why", "The first"}, folder.path());
  INFO(accepted.err);
  REQUIRE(accepted.exit_code == 0);
}

Json& first_row(Json& summary) { return summary["tables"].front()["rows"][0]; }

}  // namespace

TEST_CASE("check: accepted results are within their tolerances, with the same digits") {
  const TemporaryFolder folder;
  accept_lists(folder);
  const std::string reference = read_text(folder / kReference);
  for (const std::string part :
       {"# scenario: scenarios/own/lists.toml\n", "# commit: 0123456789\n", "# reason: The first\n",
        "# date: 20", "\ntable,row,column,value,tolerance\n", ",success_rate,"}) {
    CHECK_THAT(reference, Catch::Contains(part));
  }
  for (const std::string name : {"", "own", "own/lists", "scenarios/own/lists.toml"}) {
    CAPTURE(name);
    const auto checked = name.empty() ? run_honka({"check"}, folder.path())
                                      : run_honka({"check", name}, folder.path());
    CHECK(checked.exit_code == 0);
    CHECK(checked.err.empty());
    CHECK_THAT(checked.out, Catch::StartsWith("own/lists: same digits, "));
    CHECK_THAT(checked.out, Catch::Contains("the results are of commit 01234567"));
  }
}

TEST_CASE(
    "check: other digits within tolerance pass, figures outside are listed with exit code 1") {
  const TemporaryFolder folder;
  accept_lists(folder);
  change_summary(folder, [](Json& summary) {
    summary["results_digest"] = "another";
    first_row(summary)["time_ms"]["p50"] = 1e9;
    first_row(summary)["stems"] = first_row(summary)["stems"].get<double>() * 1.01;
  });
  const auto within = run_honka({"check"}, folder.path());
  CHECK(within.exit_code == 0);
  CHECK_THAT(within.out, Catch::Contains("other digits, within tolerance"));

  change_summary(folder, [](Json& summary) {
    first_row(summary)["success_rate"] = 0.25;
    first_row(summary).erase("wrong_rate");
  });
  const auto outside = run_honka({"check"}, folder.path());
  CHECK(outside.exit_code == 1);
  CHECK_THAT(outside.out, Catch::Contains("own/lists: 2 of "));
  CHECK_THAT(outside.out, Catch::Contains(": success_rate\n"));
  CHECK_THAT(outside.out, Catch::Contains("not there"));
  CHECK_THAT(outside.out, Catch::Contains("The first"));
}

TEST_CASE("check: without results the line says how to make them, --run makes them") {
  const TemporaryFolder folder;
  accept_lists(folder);
  std::filesystem::remove_all(folder / "results/own");
  check_refused(run_honka({"check"}, folder.path()),
                {"results/own/lists: no summary.json", "honka run scenarios/own/lists.toml"});
  const auto checked = run_honka({"check", "--run", "--threads", "1"}, folder.path());
  INFO(checked.err);
  CHECK(checked.exit_code == 0);
  CHECK_THAT(checked.out, Catch::Contains("own/lists: same digits"));
}

TEST_CASE("check: results of other keys and a scenario that changed are not compared") {
  const TemporaryFolder folder;
  accept_lists(folder);
  run_lists(folder, {"-s", "sighting.noise_m=0.2"});
  check_refused(run_honka({"check"}, folder.path()), {"with keys on top", "honka run"});
  check_refused(run_honka({"check", "--accept", "own/lists", "--why", "x"}, folder.path()),
                {"with keys on top"});
  write_lists(folder, "seed = 7\n");
  check_refused(run_honka({"check"}, folder.path()),
                {"lists.toml: the scenario has changed", "honka check --accept own/lists"});
}

TEST_CASE("check: --accept needs a reason, results that can be repeated, and a scenario") {
  const TemporaryFolder folder;
  write_lists(folder);
  const auto accept = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"check", "--accept", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_honka(arguments, folder.path());
  };
  check_refused(accept("own/lists", {}), {"--accept own/lists", "--why TEXT"});
  check_refused(accept("own/lists", {"--why", " "}), {"--why TEXT"});
  check_refused(accept("own/list", {"--why", "x"}),
                {"no such scenario", "did you mean own/lists?"});
  check_refused(accept("own/lists", {"--why", "x"}), {"no summary.json", "honka run"});
  run_lists(folder);
  change_summary(folder, [](Json& summary) { summary["context"]["dirty"] = "true"; });
  check_refused(accept("own/lists", {"--why", "x"}), {"changes that are not committed"});
  run_lists(folder, {"--trial", "0"});
  check_refused(accept("own/lists", {"--why", "x"}), {"not of all the scenario's trials"});
  CHECK_FALSE(std::filesystem::exists(folder / kReference));
}

TEST_CASE("check: unknown names and broken references are refused at their place") {
  const TemporaryFolder folder;
  check_refused(run_honka({"check"}, folder.path()), {"results/reference: no references here"});
  accept_lists(folder);
  check_refused(run_honka({"check", "own/list"}, folder.path()), {"did you mean own/lists?"});
  check_refused(run_honka({"check", "--why", "x"}, folder.path()), {"--why goes with --accept"});
  std::ofstream(folder / kReference, std::ios::app) << "a,b,c,much,1\n";
  const std::string text = read_text(folder / kReference);
  const auto lines = std::to_string(std::count(text.begin(), text.end(), '\n'));
  check_refused(run_honka({"check"}, folder.path()),
                {"lists.csv:" + lines + ":7: column 'value': 'much' is not a number"});
}
