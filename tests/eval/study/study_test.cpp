#include "eval/study/study.h"

#include <catch2/catch.hpp>

#include "algo/types/user_error.h"
#include "eval/config/study_settings.h"
#include "tests/eval/study/fake_study.h"

namespace {

using namespace honka::eval;
using honka::test::fake_study;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

std::string refusal_of_study(const TemporaryFolder& folder, const std::string& text) {
  write_raw(folder / "s.toml", "experiment = \"sighting\"\n" + text);
  return user_error_of([&] { static_cast<void>(load_study(folder / "s.toml")); });
}

}  // namespace

TEST_CASE("a grid has every combination, the last axis fastest, in the order of the file") {
  const TemporaryFolder folder;
  write_raw(folder / "s.toml",
            "experiment = \"sighting\"\n[study.vary]\nsighting.noise_m = [0.1, 0.2]\n"
            "forest.spacing.process = \"strauss, rows\"\n");
  const Study study = load_study(folder / "s.toml");
  REQUIRE(study.points.size() == 4);
  CHECK(study.axes()[0].key == "sighting.noise_m");
  CHECK(point_name(study, 1) == "sighting.noise_m = 0.1, forest.spacing.process = \"rows\"");
  CHECK(study.points[2].resolved.scenario.sighting.detector.noise_m == 0.2);
  CHECK(study.points[3].resolved.scenario.forest.spacing.process == "rows");
}

TEST_CASE("a list goes through its values together") {
  const TemporaryFolder folder;
  write_raw(folder / "s.toml",
            "experiment = \"sighting\"\n[study]\ncombine = \"list\"\n[study.vary]\n"
            "sighting.noise_m = [0.1, 0.2]\nsighting.missed_share = [0.3, 0.4]\n");
  const Study study = load_study(folder / "s.toml");
  REQUIRE(study.points.size() == 2);
  CHECK(study.points[1].resolved.scenario.sighting.detector.missed_share == 0.4);
}

TEST_CASE("what a study cannot be made of is refused with its place") {
  const TemporaryFolder folder;
  CHECK_THAT(refusal_of_study(folder, ""), Catch::Contains("nothing varies"));
  CHECK_THAT(refusal_of_study(folder, "[study.vary]\nsighting.noise_m = []\n"),
             Catch::Contains("s.toml:3:10: study.vary.sighting.noise_m is empty"));
  CHECK_THAT(refusal_of_study(folder, "[study.vary]\nsighting.nois_m = [1]\n"),
             Catch::Contains("s.toml:3:10: unknown key sighting.nois_m") &&
                 Catch::Contains("did you mean sighting.noise_m"));
  CHECK_THAT(refusal_of_study(folder, "[study.vary]\nsighting.noise_m = [0.1, -2]\n"),
             Catch::Contains("s.toml:3:10") && Catch::Contains("out of range"));
  CHECK_THAT(refusal_of_study(folder,
                              "[study]\ncombine = \"list\"\n[study.vary]\nsighting.noise_m = [0.1, "
                              "0.2]\nsighting.missed_share = [0.1]\n"),
             Catch::Contains("s.toml:6:10") && Catch::Contains("has 1 values"));
  CHECK_THAT(refusal_of_study(folder, "[study.vary]\nvariants.methods = \"li2020, consensus\"\n"),
             Catch::Contains("take them out of [study.vary]"));
}

TEST_CASE("how many trials a study has is not part of what it is, all that acts on them is") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 10);
  CHECK(fake_study(folder, 20).identity == study.identity);
  const auto file = folder / "fake.toml";
  CHECK(load_study(file, {"study.time_limit_s=7"}).identity == study.identity);
  CHECK(load_study(file, {"study.worlds=5"}).identity != study.identity);
  CHECK(load_study(file, {"sighting.missed_share=0.2"}).identity != study.identity);
  CHECK(load_study(file, {"seed=2"}).identity != study.identity);
}

TEST_CASE("an axis that the command line sets is one no more: so one trial is run alone") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 10);
  const std::string command = replay_command(study, {1, 4});
  CHECK(command ==
        "honka run " + (folder / "fake.toml").string() + " -s 'sighting.noise_m=0.2' --trial 4");
  CHECK(study_command(load_study(folder / "fake.toml", {"sighting.missed_share=0.2"}, 7)) ==
        "honka study " + (folder / "fake.toml").string() +
            " -s 'sighting.missed_share=0.2' --trials 7");
  const Study alone = load_study(folder / "fake.toml", {"sighting.noise_m=0.2"});
  REQUIRE(alone.points.size() == 1);
  CHECK(alone.points[0].resolved.hash == study.points[1].resolved.hash);
}

TEST_CASE("the table has a row a trial and method, in order, with failed ones among them") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 2);
  TrialRecord good, bad;
  good.id = {1, 1};
  good.results = {{"a", {1.0, 0.25, 3.0}}, {"b", {0.0, 0.5, 4.0}}};
  bad.id = {1, 0};
  bad.status = TrialStatus::kTimedOut;
  bad.cause = "late";
  const Table table = study_table(study, {good, bad});
  REQUIRE(table.rows() == 4);
  CHECK(table.ints("trial") == std::vector<std::int64_t>{0, 0, 1, 1});
  CHECK(table.strings("method") == std::vector<std::string>{"a", "b", "a", "b"});
  CHECK(table.strings("status")[0] == "timed_out");
  CHECK(table.doubles("sighting.noise_m") == std::vector<double>{0.2, 0.2, 0.2, 0.2});
  CHECK(std::isnan(table.doubles("success")[1]));
  CHECK(table.doubles("translation_error_m")[3] == 0.5);
  CHECK_FALSE(table.column("match_ms").in_digest);
  CHECK_FALSE(table.column("wall_s").in_digest);
  CHECK(table.column("translation_error_m").in_digest);
}
