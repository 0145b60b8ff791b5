// Ctrl-C and SIGTERM end a run with exit code 3, one line, and nothing half-written on disk.
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/system/program.h"

namespace {

using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_tiny;

/// Sends a signal once the run has begun to write: the folder holds more than the scenario.
auto once_it_writes(const TemporaryFolder& folder, int signal) {
  return [&folder, signal](int child) {
    for (int wait = 0; wait < 3000 && folder.entries() < 2; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    REQUIRE(folder.entries() > 1);
    ::kill(child, signal);
  };
}

}  // namespace

TEST_CASE("an interrupted run leaves nothing behind") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const TemporaryFolder folder;
  write_tiny(folder, "long.toml");
  const auto outcome = run_honka({"run", "long.toml", "--out", "out", "-s", "forest.length_m=3000"},
                                 folder.path(), once_it_writes(folder, signal));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(folder.entries() == 1);
  CHECK_THAT(outcome.err, Catch::Contains(signal == SIGINT ? "stopped by Ctrl-C" : "SIGTERM"));
}

TEST_CASE("an interrupted recording leaves nothing behind") {
  const TemporaryFolder folder;
  write_tiny(folder, "long.toml");
  const auto outcome =
      run_honka({"simulate", "long.toml", "--out", "long.h5", "-s", "simulate.duration_s=3600",
                 "-s", "forest.length_m=3000", "-s", "simulate.run=prior_run"},
                folder.path(), once_it_writes(folder, SIGTERM));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(folder.entries() == 1);
}
