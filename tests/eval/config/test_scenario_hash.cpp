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

TEST_CASE("keys of map updates are in the hash of map updates alone") {
  for (const char* experiment : {"localization", "sighting"}) {
    CHECK(hash_with(experiment, "map_update.passes=3") == hash_with(experiment, "title=another"));
    CHECK(hash_with(experiment, "seed=3") != hash_with(experiment, "title=another"));
  }
  CHECK(hash_with("map_update", "map_update.passes=3") != hash_with("map_update", "title=another"));
  CHECK(hash_with("map_update", "map_update.updater.range_m=20.0") !=
        hash_with("map_update", "title=another"));
}

}  // namespace honka::eval
