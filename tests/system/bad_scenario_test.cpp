// What a mistake in a scenario or on the command line gets: one line with place and remedy, exit
// code 2, and nothing on disk.
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Outcome;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
using honka::test::write_tiny;

/// Runs a scenario of this text; the folder must hold nothing but the scenario afterwards.
Outcome run_text(const std::string& text) {
  const TemporaryFolder folder;
  write_raw(folder / "bad.toml", text);
  Outcome outcome = run_honka({"run", "bad.toml", "--out", "out"}, folder.path());
  CHECK(folder.entries() == 1);
  return outcome;
}

Outcome run_with(std::vector<std::string> more) {
  const TemporaryFolder folder;
  write_tiny(folder);
  std::vector<std::string> arguments = {"run", "tiny.toml", "--out", "out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Outcome outcome = run_honka(arguments, folder.path());
  CHECK(folder.entries() == 1);
  return outcome;
}

}  // namespace

TEST_CASE("an unknown key is named with its place and the nearest known key") {
  check_refused(run_text("trials = 1\n[forest]\n  densty_per_ha = 800\n"),
                {"bad.toml:3:3: ", "unknown key forest.densty_per_ha",
                 "did you mean forest.density_per_ha", "honka scenario show"});
  check_refused(run_text("[forrest]\nwidth_m = 80.0\n"),
                {"bad.toml:2:1: ", "forrest.width_m", "did you mean forest.width_m"});
}

TEST_CASE("a wrong type, a value out of range and an unknown word are located") {
  check_refused(run_text("[forest]\nwidth_m = \"wide\"\n"),
                {"bad.toml:2:1: ", "forest.width_m must be a number", "\"wide\""});
  check_refused(run_text("trials = 1.5\n"), {"bad.toml:1:1: ", "trials must be a whole number"});
  check_refused(run_text("\n\n[lidar]\nrotation_rate_hz = 30.0\n"),
                {"bad.toml:4:1: ", "lidar.rotation_rate_hz = 30", "between 5 and 20 Hz"});
  check_refused(run_text("forest.density_per_ha = nan\n"),
                {"bad.toml:1:8: ", "forest.density_per_ha = nan", "between 1 and 20000"});
  check_refused(run_text("[map]\nsource = \"prior_rum\"\n"),
                {"bad.toml:2:1: ", "map.source", "did you mean \"prior_run\"?", "same_run"});
  check_refused(run_text("localize.method = \"li2021\"\n"),
                {"bad.toml:1:10: ", "did you mean \"li2020\"?"});
  check_refused(run_text("localize.li2020.stars = \"space\"\n"),
                {"bad.toml:1:17: ", "localize.li2020.stars", "\"plane\"", "options.slopes_deg"});
}

TEST_CASE("a scenario that is no TOML, or missing, or of an unknown experiment is refused") {
  check_refused(run_text("trials = [1\n"), {"bad.toml:1:"});
  check_refused(run_text("trials = 1\ntrials = 2\n"), {"bad.toml:2:", "trials"});
  check_refused(run_text("trials = 2026-01-01\n"), {"bad.toml:1:1", "dates", "give a number"});
  check_refused(run_text("experiment = \"localisation\"\n"),
                {"bad.toml:1:1: ", "experiment", "did you mean \"localization\"?"});
  const TemporaryFolder folder;
  check_refused(run_honka({"run", "none.toml"}, folder.path()),
                {"none.toml: no such scenario file", "ls scenarios"});
  check_refused(run_honka({"scenario", "check", "."}, folder.path()), {"no such scenario file"});
  CHECK(folder.entries() == 0);
}

TEST_CASE("lists of frames and tolerances that count windows twice are refused") {
  check_refused(run_text("protocol.frames = []\n"),
                {"bad.toml:1:10: ", "protocol.frames is empty"});
  check_refused(run_text("protocol.frames = [3, 1, 3]\n"),
                {"bad.toml:1:10: ", "protocol.frames must increase"});
  check_refused(run_text("variants.tolerances_m2 = [3.5, 3.5]\n"),
                {"bad.toml:1:10: ", "variants.tolerances_m2 must increase"});
}

TEST_CASE("a mistake that shows while the world is built is led back to its line") {
  check_refused(run_text("trials = 1\n[forest]\nspacing.process = \"strauss\"\n"
                         "density_per_ha = 20000.0\nspacing.strauss.factors = [0.0]\n"
                         "spacing.strauss.radii = [1.5]\nwidth_m = 40.0\nlength_m = 40.0\n"),
                {"bad.toml:4:1: ", "do not fit at this density", "lower forest.density_per_ha"});
  check_refused(run_with({"-s", "protocol.path_length_m=5.0", "-s", "protocol.frames=[90]"}),
                {"-s protocol.path_length_m=5.0: ", "holds no window of 90 key frames"});
}

TEST_CASE("a bad override is named as it was typed") {
  check_refused(run_with({"-s", "forest.densty_per_ha=3"}),
                {"-s forest.densty_per_ha=3: ", "did you mean forest.density_per_ha"});
  check_refused(run_with({"-s", "forest.density_per_ha=many"}),
                {"-s forest.density_per_ha=many: ", "must be a number"});
  check_refused(run_with({"-s", "nonsense"}), {"-s nonsense: ", "write -s key=value"});
  check_refused(run_with({"--seed", "-1"}), {"seed = -1", "out of range"});
}

TEST_CASE("a bad command line is refused in one line") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    check_refused(run_honka(arguments, folder.path()), {part});
  };
  refused({"frobnicate"}, "frobnicate");
  refused({"run"}, "SCENARIO is required; see honka help");
  refused({"run", "tiny.toml", "--threads", "-1"}, "--threads: Value -1 not in range 0 to 1024");
  refused({"run", "tiny.toml", "--threads", "two"}, "--threads");
  refused({"run", "tiny.toml", "--out", "out", "--trial", "1"},
          "--trial 1: tiny.toml has the trials 0 to 0");
  refused({"help", "frobnicate"}, "no help on \"frobnicate\"");
  refused({"report", "none"}, "no such file");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a forest that cannot be placed says so instead of looping") {
  check_refused(run_with({"-s", "forest.spacing.process=hard_core", "-s",
                          "forest.spacing.hard_core.core=1", "-s", "forest.density_per_ha=5000"}),
                {"forest.spacing.hard_core", "do not fit", "lower forest.density_per_ha"});
}

TEST_CASE("a drive too short for one window says so") {
  check_refused(
      run_with({"-s", "protocol.frames=[100]"}),
      {"tiny.toml:", "protocol.path_length_m: ", "no window of 100 key frames", "lengthen"});
}

TEST_CASE("a missing measured stand is named with the key that asks for it") {
  check_refused(run_with({"-s", "forest.stem_map=plot.csv"}),
                {"-s forest.stem_map=plot.csv: forest.stem_map: plot.csv: no such file"});
  const TemporaryFolder folder;
  check_refused(run_honka({"scenario", "check", HONKA_SOURCE_DIR "/scenarios/li2020/stem_map.toml"},
                          folder.path()),
                {"stem_map.toml:", "forest.stem_map", "no such file"});
}
