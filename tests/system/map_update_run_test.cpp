// honka run on a stand that was thinned since it was mapped, as a user runs it.
#include <fstream>

#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::read_json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

constexpr const char* kTinyDrive = R"(experiment = "map_update"
trials = 2
[forest]
width_m = 80.0
length_m = 90.0
density_per_ha = 367.0
spacing.process = "strauss"
spacing.strauss.sweeps = 5
[map]
source = "inventory"
[variants]
methods = "li2020, consensus"
[map_update]
thinned_to_per_ha = [200.0]
view_every_m = 10.0
update_every = 7
)";

}  // namespace

TEST_CASE("a run with map updates leaves tables, figures and a report, whatever the threads") {
  const TemporaryFolder folder;
  std::ofstream(folder / "drive.toml") << kTinyDrive;
  for (const char* threads : {"1", "2"}) {
    const auto outcome = run_honka(
        {"run", "drive.toml", "--threads", threads, "--out", std::string("out") + threads},
        folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("updated by consensus"));
  }
  const Json one = read_json(folder / "out1/summary.json");
  CHECK(one["results_digest"] == read_json(folder / "out2/summary.json")["results_digest"]);
  const Json rows = one["tables"]["map_update"]["rows"];
  REQUIRE(rows.size() == 2 * 4 * 5);  // methods, maps, the whole drive and its quarters
  for (const Json& row : rows) {
    for (const char* key :
         {"method", "map", "frames", "stems_in_map", "queries", "success_rate", "success_interval",
          "wrong_rate", "refused_rate", "time_ms", "thinned_to_per_ha", "part"}) {
      CHECK(row.contains(key));
    }
  }
  CHECK(rows[0]["queries"] == 2 * 2 * 4 * 9);  // trials, passes, roads, lists a road
  const Json maps = one["tables"]["map_quality"]["rows"];
  REQUIRE(maps.size() == 2 * 5);
  CHECK(maps[0]["felled_retired"]["n"] == 0);
  CHECK(maps[0]["precision"]["of"].get<int>() > 0);
  for (const char* file : {"report.html", "trials.h5", "figures/map_before_after.gp",
                           "figures/success_along_drive_200.gp", "figures/map_quality.gp"}) {
    CHECK(fs::exists(folder / "out1" / file));
  }
}

TEST_CASE("what a user mistypes of a map update is told with its place") {
  const TemporaryFolder folder;
  std::ofstream(folder / "drive.toml") << kTinyDrive;
  const auto refuse = [&](const std::vector<std::string>& more,
                          const std::vector<std::string>& parts) {
    std::vector<std::string> arguments = {"run", "drive.toml", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    check_refused(run_honka(arguments, folder.path()), parts);
    CHECK_FALSE(fs::exists(folder / "out"));
  };
  refuse({"--trial", "2"}, {"--trial 2", "0 to 1"});
  refuse({"-s", "map_update.thinned_to_per_ha=[]"}, {"map_update.thinned_to_per_ha"});
  refuse({"-s", "map_update.update_every=0"}, {"map_update.update_every"});
  refuse({"-s", "map_update.updater.rnge_m=20"}, {"rnge_m", "range_m"});
  refuse({"-s", "map.source=prior_run"}, {"map.source", "inventory"});
  refuse({"-s", "map_update.strip_road_spacing_m=4.0"}, {"strip_road_spacing_m"});
}
