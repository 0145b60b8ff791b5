// Whole scenarios at their size; hidden, run by scripts/test --slow.
#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::test::Json;
using honka::test::read_json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;

const std::string kScenarios = HONKA_SOURCE_DIR "/scenarios/";

Json run(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "run");
  arguments.insert(arguments.end(), {"--out", "out"});
  const auto outcome = run_honka(arguments, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return read_json(folder / "out/summary.json");
}

}  // namespace

TEST_CASE("quick.toml at full size: one digest for one and two threads, success with frames",
          "[.slow]") {
  const TemporaryFolder folder;
  const Json one = run(folder, {kScenarios + "quick.toml", "--threads", "1"});
  const Json two = run(folder, {kScenarios + "quick.toml", "--threads", "2"});
  CHECK(one["results_digest"] == two["results_digest"]);
  CHECK(one["scenario_hash"] == two["scenario_hash"]);
  const Json& rows = one["tables"]["table1"]["rows"];
  CHECK(one["tables"] != Json());
  REQUIRE(rows.size() == 8);
  double last = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(rows[i]["windows"] == 20);
    CHECK(rows[i]["success_rate"] >= last);
    CHECK(rows[i]["wrong_rate"] <= 0.05);
    last = rows[i]["success_rate"];
  }
  CHECK(last >= 0.95);
}

TEST_CASE("stem_map.toml on a real plot", "[.slow]") {
  const auto file = honka::test::shared("data/stem_maps/ilomantsi_p06.csv");
  if (!std::filesystem::exists(file)) {
    WARN("skipped: " << file << " is absent");
    return;
  }
  const TemporaryFolder folder;
  const Json summary =
      run(folder, {kScenarios + "li2020/stem_map.toml", "-s", "forest.stem_map=" + file.string()});
  const auto trials = honka::eval::read_table(folder / "out/trials.h5", "trials");
  CHECK(trials.ints("measured_trees")[0] > 50);
  const Json& rows = summary["tables"]["table1"]["rows"];
  CHECK(rows[3]["frames"] == 10);
  CHECK(rows[3]["success_rate"] > rows[0]["success_rate"]);
  CHECK(rows[3]["wrong_rate"] <= 0.05);
}
