// What a scenario's hash tells apart: results that differ, not names or experiments that are not
// run.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "eval/config/scenario.h"

namespace honka::eval {
namespace {

std::string hash_with(const std::string& experiment, const std::string& override_text) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("honka-hash-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scenario.toml") << "experiment = \"" << experiment << "\"\n";
  const std::string hash = load_scenario(folder / "scenario.toml", {override_text}).hash;
  std::filesystem::remove_all(folder);
  return hash;
}

}  // namespace

TEST_CASE("keys that one experiment reads are in its hash alone") {
  const auto [experiment, key] =
      GENERATE(table<std::string, std::string>({{"map_update", "map_update.passes=3"},
                                                {"map_update", "map_update.updater.range_m=20.0"},
                                                {"options", "options.queries=3"},
                                                {"tracking", "tracking.lost_after=3"},
                                                {"stem_pairs", "pairs.within_m=0.5"}}));
  CAPTURE(experiment, key);
  CHECK(hash_with(experiment, key) != hash_with(experiment, "title=another"));
  for (const char* other : {"localization", "sighting"}) {
    CHECK(hash_with(other, key) == hash_with(other, "title=another"));
    CHECK(hash_with(other, "seed=3") != hash_with(other, "title=another"));
  }
}

}  // namespace honka::eval
