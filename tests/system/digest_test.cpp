// The same scenario and seed give the same digits: in a second run, whatever the threads, and
// whether a trial runs alone or among others.
#include <cstring>

#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::eval::Column;
using honka::eval::read_table;
using honka::eval::Table;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_tiny;

std::string digest_of(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", "tiny.toml", "--out", "out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto outcome = run_honka(arguments, folder.path());
  REQUIRE(outcome.exit_code == 0);
  const std::string digest =
      honka::test::read_json(folder / "out/summary.json")["results_digest"].get<std::string>();
  CHECK(digest.size() == 64);
  CHECK_THAT(outcome.out, Catch::Contains("results_digest " + digest));
  return digest;
}

/// The cells of the digest's columns but the trial's number in the rows of one trial, as bits.
std::vector<std::string> rows_of(const Table& table, std::int64_t trial) {
  std::vector<std::string> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.ints("trial")[row] != trial) continue;
    std::string cells;
    for (const Column& column : table.columns()) {
      if (!column.in_digest || column.name == "trial") continue;
      if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
        cells += (*texts)[row] + ";";
      } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values)) {
        cells += std::to_string((*integers)[row]) + ";";
      } else {
        char bits[sizeof(double)];
        std::memcpy(bits, &std::get<std::vector<double>>(column.values)[row], sizeof bits);
        cells.append(bits, sizeof bits);
      }
    }
    rows.push_back(cells);
  }
  return rows;
}

}  // namespace

TEST_CASE("the digest is the same whatever the threads, the title and the number of runs") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const std::string one = digest_of(folder, {"--threads", "1"});
  CHECK(digest_of(folder, {"--threads", "2"}) == one);
  CHECK(digest_of(folder, {"--threads", "2", "-s", "title=Another"}) == one);
  CHECK(digest_of(folder, {"--seed", "2"}) != one);
}

TEST_CASE("a lidar odometry in place of truth and noise: the same digest whatever the threads") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const std::vector<std::string> loam = {"-s", "odometry.source=loam", "--threads"};
  auto with = [&](const std::string& threads) {
    auto arguments = loam;
    arguments.push_back(threads);
    return digest_of(folder, arguments);
  };
  const std::string one = with("1");
  CHECK(with("2") == one);
  const auto summary = honka::test::read_json(folder / "out/summary.json");
  CHECK(summary["scenario"]["odometry.source"] == "loam");
  CHECK(summary["scenario"]["map.source"] == "prior_run");
  for (const std::string run : {"prior", "work"}) {
    const auto judged = run_honka({"evaluate", "out/stand_0_" + run + "_truth.tum",
                                   "out/stand_0_" + run + ".tum", "--align", "yaw", "--json"},
                                  folder.path());
    REQUIRE(judged.exit_code == 0);
    CHECK(honka::test::Json::parse(judged.out)["ape"]["translation_m"]["rmse"] < 0.3);
  }
  for (const auto& row : summary["tables"]["table1"]["rows"]) {
    CHECK(row["windows"].get<int>() > 0);
  }
}

TEST_CASE("a trial alone has the rows that it has among others") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const auto run = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"run", "tiny.toml", "-s", "trials=2", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(run_honka(arguments, folder.path()).exit_code == 0);
  };
  run("both", {});
  run("alone", {"--trial", "1"});
  for (const std::string group : {"trials", "frames"}) {
    const Table both = read_table(folder / "both/trials.h5", group);
    const Table alone = read_table(folder / "alone/trials.h5", group);
    CAPTURE(group);
    CHECK(rows_of(alone, 0).empty());
    REQUIRE_FALSE(rows_of(alone, 1).empty());
    CHECK((rows_of(alone, 1) == rows_of(both, 1)));
    CHECK((rows_of(both, 0) != rows_of(both, 1)));
  }
}
