// honka scenario check, show, diff, and the scenarios that ship with honka.
#include <algorithm>
#include <sstream>

#include "eval/config/scenario.h"
#include "tests/system/program.h"

namespace {

using honka::eval::KeyEntry;
using honka::eval::load_scenario;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
using honka::test::write_tiny;
namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const char* const kSquare = "x_m,y_m\n0,0\n4,0\n0,4\n4,4\n9,5\n";

}  // namespace

TEST_CASE("scenario show lists every key once with value, unit, origin and source") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const auto outcome =
      run_honka({"scenario", "show", "tiny.toml", "-s", "lidar.range_noise_m=0.02"}, folder.path());
  CHECK(outcome.exit_code == 0);
  const auto lines = lines_of(outcome.out);
  const auto keys = honka::eval::list_keys({});
  CHECK(keys.size() > 100);
  for (const KeyEntry& key : keys) {
    CAPTURE(key.key);
    CHECK_FALSE(key.help.empty());
    CHECK_FALSE(key.source.empty());
    CHECK(std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
            return line.starts_with(key.key + " = ");
          }) == 1);
  }
  CHECK_THAT(outcome.out, Catch::Contains("lidar.range_noise_m = 0.02 [m] (0 to 1) · -s "
                                          "lidar.range_noise_m=0.02, default 0.01"));
  CHECK_THAT(outcome.out,
             Catch::Contains("forest.width_m = 60.0 [m] (5 to 20000) · tiny.toml:4:8, default"));
  CHECK_THAT(outcome.out, Catch::Contains("lidar.max_range_m = 100.0 [m] (1 to 131) · default"));
}

TEST_CASE("scenario diff tells the keys that differ and no others") {
  const TemporaryFolder folder;
  write_tiny(folder);
  write_tiny(folder, "other.toml", "harvester.work_cycle = false\n");
  const auto same = run_honka({"scenario", "diff", "tiny.toml", "tiny.toml"}, folder.path());
  CHECK(same.exit_code == 0);
  CHECK(same.out.starts_with("0 of "));
  const auto outcome = run_honka({"scenario", "diff", "tiny.toml", "other.toml"}, folder.path());
  CHECK(outcome.exit_code == 0);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "harvester.work_cycle = true | false");
  CHECK(lines[1].starts_with("1 of "));
  const auto defaults = run_honka({"scenario", "diff", "tiny.toml"}, folder.path());
  CHECK_THAT(defaults.out, Catch::Contains("forest.width_m = 60.0 | 200.0"));
}

TEST_CASE("the resolved scenario as TOML reads back to the same hash") {
  const TemporaryFolder folder;
  write_raw(folder / "plot.csv", kSquare);
  for (const auto& entry : fs::recursive_directory_iterator(HONKA_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path());
    std::vector<std::string> overrides;
    if (entry.path().filename() == "stem_map.toml") {
      overrides.push_back("forest.stem_map=" + (folder / "plot.csv").string());
    }
    const auto resolved = load_scenario(entry.path(), overrides);
    write_raw(folder / "again.toml", honka::eval::to_toml(resolved.scenario));
    const auto again = load_scenario(folder / "again.toml");
    CHECK(again.hash == resolved.hash);
    CHECK(again.scenario.title == resolved.scenario.title);
  }
}

TEST_CASE("the hash follows what changes results: a key, a measured stem") {
  const TemporaryFolder folder;
  write_tiny(folder);
  write_raw(folder / "a.csv", kSquare);
  write_raw(folder / "b.csv", std::string(kSquare) + "15,15\n");
  const auto hash = [&](const std::vector<std::string>& overrides) {
    return load_scenario(folder / "tiny.toml", overrides).hash;
  };
  CHECK(hash({"title=x"}) == hash({}));
  CHECK(hash({"trials=2"}) != hash({}));
  CHECK(hash({"forest.stem_map=a.csv"}) != hash({}));
  CHECK(hash({"forest.stem_map=a.csv"}) != hash({"forest.stem_map=b.csv"}));
  fs::copy_file(folder / "a.csv", folder / "copy.csv");
  CHECK(hash({"forest.stem_map=a.csv"}) == hash({"forest.stem_map=copy.csv"}));
}

TEST_CASE("every scenario that ships passes scenario check") {
  const TemporaryFolder folder;
  write_raw(folder / "plot.csv", kSquare);
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(HONKA_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    std::vector<std::string> arguments = {"scenario", "check", entry.path().string()};
    if (entry.path().filename() == "stem_map.toml") {
      arguments.insert(arguments.end(), {"-s", "forest.stem_map=plot.csv"});
    }
    const auto outcome = run_honka(arguments, folder.path());
    CAPTURE(entry.path(), outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("well formed"));
    CHECK(outcome.err.empty());
  }
  CHECK(files >= 3);
}

TEST_CASE("help knows the verbs, the experiments, the formats and every key") {
  const TemporaryFolder folder;
  const auto help = [&](const std::vector<std::string>& topic) {
    std::vector<std::string> arguments = {"help"};
    arguments.insert(arguments.end(), topic.begin(), topic.end());
    const auto outcome = run_honka(arguments, folder.path());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
  };
  for (const char* verb :
       {"run", "simulate", "locate", "score", "evaluate", "report", "scenario", "help"}) {
    CHECK_THAT(help({}), Catch::Contains(std::string("\n  ") + verb));
  }
  CHECK(run_honka({}, folder.path()).out == help({}));
  CHECK_THAT(help({"experiments"}), Catch::Contains("localization") && Catch::Contains("li2020"));
  CHECK_THAT(help({"formats"}), Catch::Contains("trials.h5") && Catch::Contains("x_m,y_m"));
  CHECK(lines_of(help({"keys"})).size() == honka::eval::list_keys({}).size());
}
