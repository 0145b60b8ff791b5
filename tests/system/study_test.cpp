// A study as a user runs it: killed, ended, cut off from its disk, resumed, replayed.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "algo/types/random.h"
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::read_json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

/// Small forests without rays: some milliseconds a trial.
void write_study(const TemporaryFolder& folder, int trials) {
  honka::test::write_raw(folder / "study.toml",
                         "experiment = \"sighting\"\n"
                         "[variants]\nmethods = \"li2020, consensus\"\n"
                         "[sighting]\nrange_m = 20.0\nborder_m = 15.0\nmap.stems = 200\n"
                         "[study]\nworlds = 2\ntrials = " +
                             std::to_string(trials) +
                             "\n[study.vary]\nsighting.noise_m = [0.05, 0.3]\n");
}

std::string study_digest(const TemporaryFolder& folder, const std::string& out) {
  return read_json(folder.path() / out / "summary.json").at("results_digest");
}

void require_done(const honka::test::Outcome& outcome) {
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
}

}  // namespace

TEST_CASE("killed at thirty random moments, a study ends with the digest of an undisturbed one") {
  const TemporaryFolder folder;
  write_study(folder, 300);
  require_done(
      run_honka({"study", "study.toml", "--threads", "1", "--out", "plain"}, folder.path()));
  honka::RandomStream moments(7, "kills", {});
  constexpr int kKills = 30, kMostMilliseconds = 120;
  int killed = 0;
  for (int attempt = 0; attempt < kKills; ++attempt) {
    const std::chrono::milliseconds wait(static_cast<int>(kMostMilliseconds * moments.uniform()));
    const auto outcome = run_honka({"study", "study.toml", "--threads", "2", "--out", "killed"},
                                   folder.path(), [&](int child) {
                                     std::this_thread::sleep_for(wait);
                                     ::kill(child, SIGKILL);
                                   });
    INFO(outcome.err);
    CHECK((outcome.exit_code == 128 + SIGKILL || outcome.exit_code == 0));
    killed += outcome.exit_code == 128 + SIGKILL;
  }
  CHECK(killed >= kKills / 2);
  require_done(run_honka({"study", "study.toml", "--out", "killed"}, folder.path()));
  CHECK(study_digest(folder, "killed") == study_digest(folder, "plain"));
}

TEST_CASE("SIGTERM ends a study cleanly, and the same command goes on") {
  const TemporaryFolder folder;
  write_study(folder, 2000);
  const auto journal = folder / "out/shards/shard-0000-of-0001.journal";
  const std::vector<std::string> command = {"study", "study.toml", "--out", "out"};
  const auto outcome = run_honka(command, folder.path(), [&](int child) {
    constexpr std::uintmax_t kSomeTrials = 2000;
    std::error_code ignored;
    for (int k = 0; k < 3000 && !(fs::file_size(journal, ignored) + 1 > kSomeTrials); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ::kill(child, SIGTERM);
  });
  CHECK(outcome.exit_code == 3);
  CHECK_THAT(outcome.err, Catch::Contains("every finished trial is kept"));
  const auto status = run_honka({"study", "status", "out"}, folder.path());
  require_done(status);
  CHECK_THAT(status.out, Catch::Contains("stopped") && Catch::Contains("Next: honka study"));
  check_refused(run_honka({"study", "merge", "out"}, folder.path()), {"out", "is not finished"});
}

TEST_CASE("a full disk stops a study with one line, and it can be gone on with") {
  const TemporaryFolder folder;
  write_study(folder, 200);
  // Files of at most 20 blocks of 512 or 1024 bytes, and no signal for it: as a full disk does.
  const std::string command = "cd '" + folder.path().string() +
                              "' && ulimit -f 20 && trap '' XFSZ && '" + HONKA_BINARY_DIR +
                              "/honka' study study.toml --threads 2 --out out 2>err.txt >out.txt";
  const int status = std::system(("bash -c \"" + command + "\"").c_str());
  const std::string said = honka::test::read_text(folder / "err.txt");
  INFO(said);
  CHECK(WEXITSTATUS(status) == 3);
  CHECK_THAT(said, Catch::Contains("cannot be written") &&
                       Catch::Contains("give the same command to go on"));
  require_done(run_honka({"study", "study.toml", "--out", "out"}, folder.path()));
  require_done(run_honka({"study", "study.toml", "--out", "plain"}, folder.path()));
  CHECK(study_digest(folder, "out") == study_digest(folder, "plain"));
}

TEST_CASE("two processes on one shard: the second is refused and the first goes on") {
  const TemporaryFolder folder;
  write_study(folder, 300);
  const std::vector<std::string> command = {"study", "study.toml", "--threads",
                                            "1",     "--out",      "out"};
  const auto first = run_honka(command, folder.path(), [&](int) {
    const auto journal = folder / "out/shards/shard-0000-of-0001.journal";
    for (int k = 0; k < 3000 && !fs::exists(journal); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    check_refused(run_honka(command, folder.path()), {"another process works on this shard"});
  });
  require_done(first);
}

TEST_CASE("shards are run, merged and give the digest of one run") {
  const TemporaryFolder folder;
  write_study(folder, 40);
  require_done(run_honka({"study", "study.toml", "--out", "plain"}, folder.path()));
  for (const char* shard : {"2/3", "0/3", "1/3"}) {
    require_done(
        run_honka({"study", "study.toml", "--shard", shard, "--out", "parts"}, folder.path()));
  }
  const auto merged = run_honka({"study", "merge", "parts"}, folder.path());
  require_done(merged);
  CHECK_THAT(merged.out, Catch::Contains(study_digest(folder, "plain")));
  CHECK(study_digest(folder, "parts") == study_digest(folder, "plain"));
  CHECK(fs::exists(folder / "parts/report.html"));
  CHECK(fs::exists(folder / "parts/trials.h5"));
}

TEST_CASE("one trial of a study alone, and the way to study where none is named") {
  const TemporaryFolder folder;
  write_study(folder, 10);
  const auto trial =
      run_honka({"run", "study.toml", "-s", "sighting.noise_m=0.3", "--trial", "7"}, folder.path());
  require_done(trial);
  CHECK_THAT(trial.out, Catch::Contains("consensus") && Catch::Contains("translation_error_m"));
  check_refused(run_honka({"run", "study.toml"}, folder.path()), {"honka study study.toml"});
  check_refused(run_honka({"run", "study.toml", "--trial", "7"}, folder.path()),
                {"-s sighting.noise_m=VALUE"});
}

TEST_CASE("what honka study is given wrongly is refused") {
  const TemporaryFolder folder;
  write_study(folder, 10);
  check_refused(run_honka({"study"}, folder.path()), {"no scenario given"});
  check_refused(run_honka({"study", "none.toml"}, folder.path()), {"none.toml", "no such"});
  check_refused(run_honka({"study", "study.toml", "--shard", "3/3"}, folder.path()),
                {"--shard 3/3", "from 0 to N - 1"});
  check_refused(run_honka({"study", "status", "nowhere"}, folder.path()), {"holds no study"});
  check_refused(run_honka({"study", "merge", "nowhere"}, folder.path()), {"holds no study"});
  check_refused(run_honka({"study", "study.toml", "-s", "experiment=odometry"}, folder.path()),
                {"experiment = \"odometry\" cannot be studied"});
}
