#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <optional>

#include "algo/types/user_error.h"
#include "eval/config/key_table.h"
#include "eval/config/scenario_reader.h"

namespace honka::eval {
namespace {

struct Sample {
  double density_per_ha = 367.0;
  std::int64_t trials = 3;
  bool branches = true;
  std::string process = "strauss";
  std::vector<double> tolerances_m2 = {3.5, 4.5};
  std::vector<std::int64_t> frames = {1, 3};
};

void describe(SettingsVisitor& v, Sample& s) {
  v.field({"trials", "", "stands", "choice"}, s.trials, {1, 100});
  v.group("forest", [&] {
    v.field({"density_per_ha", "1/ha", "stems", "Li2020"}, s.density_per_ha, {1, 5000});
    v.field({"branches", "", "with branches", "choice"}, s.branches);
    v.field({"process", "", "spacing", "choice"}, s.process, {"strauss", "poisson"});
  });
  v.field({"tolerances_m2", "m2", "tolerances", "choice"}, s.tolerances_m2, {0, 100});
  v.field({"frames", "", "window sizes", "Li2020"}, s.frames, {1, 100});
}

/// A file "scenario.toml" with the given text, in a folder of its own.
std::string written(const std::string& text) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("honka-config-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto file = folder / "scenario.toml";
  std::ofstream(file) << text;
  return file.string();
}

Sample read(const std::string& text) {
  Sample sample;
  const LocatedValues values = read_toml(written(text));
  ScenarioReader reader(values);
  describe(reader, sample);
  reader.check_all_read();
  return sample;
}

/// The message of the UserError, with the folder taken off.
std::string mistake(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const UserError& error) {
    const std::string message = error.what();
    const auto file = message.find("scenario.toml");
    return file == std::string::npos ? message : message.substr(file);
  }
  return "no error";
}

}  // namespace

TEST_CASE("Values reach the settings, defaults stay") {
  const Sample sample = read("trials = 7\nframes = [1, 10]\n[forest]\nprocess = \"poisson\"\n");
  REQUIRE(sample.trials == 7);
  REQUIRE(sample.frames == std::vector<std::int64_t>{1, 10});
  REQUIRE(sample.process == "poisson");
  REQUIRE(sample.density_per_ha == 367.0);
  REQUIRE(sample.tolerances_m2 == std::vector<double>{3.5, 4.5});
}

TEST_CASE("A whole number may stand for a number, not the other way round") {
  REQUIRE(read("forest.density_per_ha = 500\n").density_per_ha == 500.0);
  REQUIRE(read("tolerances_m2 = [2, 9]\n").tolerances_m2 == std::vector<double>{2.0, 9.0});
  REQUIRE(mistake("trials = 1.5\n") ==
          "scenario.toml:1:1: trials must be a whole number, not a number (1.5)");
}

TEST_CASE("Mistakes are located and carry a remedy") {
  using Catch::StartsWith;
  CHECK_THAT(mistake("[forest]\ndensty_per_ha = 3\n"),
             StartsWith("scenario.toml:2:1: unknown key forest.densty_per_ha; did you mean "
                        "forest.density_per_ha?"));
  CHECK_THAT(mistake("density_per_ha = 3\n"),
             StartsWith("scenario.toml:1:1: unknown key density_per_ha; did you mean "
                        "forest.density_per_ha?"));
  CHECK_THAT(mistake("[forest]\n  process = \"straus\"\n"),
             StartsWith("scenario.toml:2:3: forest.process = \"straus\" is not known; did you mean "
                        "\"strauss\"?; it may be strauss, poisson"));
  CHECK_THAT(mistake("\ntrials = 0\n"),
             StartsWith("scenario.toml:2:1: trials = 0 is out of range; it must be between 1 and "
                        "100"));
  CHECK_THAT(mistake("forest.density_per_ha = nan\n"), StartsWith("scenario.toml:1:8: forest."));
  CHECK_THAT(mistake("forest = 3\n"), StartsWith("scenario.toml:1:1: unknown key forest"));
  CHECK_THAT(mistake("trials = \"many\"\n"),
             StartsWith("scenario.toml:1:1: trials must be a whole number, not a text"));
  CHECK_THAT(mistake("frames = [1, \"two\"]\n"),
             StartsWith("scenario.toml:1:10: a list may hold numbers only"));
  CHECK_THAT(mistake("trials = 1\ntrials = 2\n"), StartsWith("scenario.toml:2:"));
  CHECK_THAT(mistake("[forest\n"), StartsWith("scenario.toml:1:"));
  CHECK_THAT(mistake("trials = 1979-05-27\n"), StartsWith("scenario.toml:1:10: dates"));
}

TEST_CASE("A missing file is one line") {
  REQUIRE_THROWS_WITH(read_toml("nowhere/x.toml"),
                      Catch::StartsWith("nowhere/x.toml: no such scenario file"));
}

TEST_CASE("Overrides are TOML values, bare words are texts") {
  REQUIRE(std::get<std::int64_t>(parse_override("a.b=3").second.value) == 3);
  REQUIRE(std::get<double>(parse_override("a=3e1").second.value) == 30.0);
  REQUIRE(std::get<bool>(parse_override("a=true").second.value));
  REQUIRE(std::get<std::string>(parse_override("a=/x/y.csv").second.value) == "/x/y.csv");
  REQUIRE(std::get<std::string>(parse_override("a=same_run").second.value) == "same_run");
  REQUIRE(std::get<std::vector<double>>(parse_override("a=[1, 2.5]").second.value).size() == 2);
  REQUIRE_THROWS_AS(parse_override("novalue"), UserError);
  REQUIRE_THROWS_AS(parse_override("=3"), UserError);
}

TEST_CASE("The key table names each field once, in order, with its groups") {
  Sample sample;
  KeyTable table;
  describe(table, sample);
  REQUIRE(table.entries().size() == 6);
  REQUIRE(table.entries()[1].key == "forest.density_per_ha");
  REQUIRE(table.entries()[1].unit == "1/ha");
  REQUIRE(format_value(table.entries()[1].value) == "367.0");
  REQUIRE(format_value(table.find("tolerances_m2")->value) == "[3.5, 4.5]");
  REQUIRE(table.find("nothing") == nullptr);
}

TEST_CASE("Values are written so that they read back the same") {
  const Value value =
      GENERATE(Value{0.1}, Value{1e-9}, Value{3.0}, Value{std::int64_t{-4}}, Value{true},
               Value{std::string{"say \"a\\b\"\nline"}}, Value{std::vector<double>{1.0, 0.3}},
               Value{std::vector<std::int64_t>{1, 10}});
  REQUIRE(parse_override("v=" + format_value(value)).second.value == value);
}

TEST_CASE("The nearest word") {
  REQUIRE(nearest_word("range_nois_m", {"lidar.range_noise_m", "range_noise_m"}) ==
          "range_noise_m");
  REQUIRE(nearest_word("zzzzzzzzzz", {"forest.density_per_ha"}).empty());
}

}  // namespace honka::eval
