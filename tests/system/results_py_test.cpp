// scripts/results.py opens the trials of a study in pandas.
#include <algorithm>
#include <cstdlib>

#include "tests/system/program.h"

namespace {

using honka::test::read_text;
using honka::test::TemporaryFolder;

const std::string kPython = "/usr/bin/python3 ";

}  // namespace

TEST_CASE("results.py prints the success rate of each point and method") {
  if (std::system((kPython + "-c 'import pandas, h5py' 2> /dev/null").c_str()) != 0) {
    WARN("skipped: python3-pandas or python3-h5py is absent");
    return;
  }
  const TemporaryFolder folder;
  honka::test::write_raw(folder / "study.toml", R"(experiment = "sighting"
forest.density_per_ha = 367.0
variants.methods = "li2020, consensus"
sighting.map.stems = 200
[study]
trials = 20
worlds = 2
vary.sighting.noise_m = [0.05, 0.3]
)");
  const auto study = honka::test::run_honka({"study", "study.toml", "--out", "out"}, folder.path());
  INFO(study.err);
  REQUIRE(study.exit_code == 0);
  const std::string script = std::string(HONKA_SOURCE_DIR) + "/scripts/results.py";
  const std::string command =
      kPython + script + " " + (folder / "out").string() + " > " + (folder / "said").string();
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string said = read_text(folder / "said");
  INFO(said);
  CHECK_THAT(said, Catch::Contains("sighting.noise_m"));
  CHECK_THAT(said, Catch::Contains("0.05"));
  CHECK_THAT(said, Catch::Contains("consensus"));
  const auto rows = static_cast<std::size_t>(std::count(said.begin(), said.end(), '\n'));
  CHECK(rows == 2 + 2 * 2);
  CHECK_THAT(said, Catch::Contains(" 20\n"));
}
