// Reference files: read back as written, broken ones refused at their place, and what comparing
// with one says.
#include <catch2/catch.hpp>
#include <fstream>

#include "eval/run/check/compare.h"
#include "eval/run/check/reference.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

namespace {

CheckFigure number_figure(const std::string& row, double value, double tolerance,
                          const std::string& table = "table1") {
  return {table, row, "rate", value, "", tolerance};
}

CheckFigure word_figure(const std::string& row, const std::string& word) {
  return {"table1", row, "verdict", {}, word, 0.0};
}

Reference small_reference() {
  return {"scenarios/a/b.toml",
          "hash",
          "digest",
          "commit",
          "GNU 12",
          "2026-01-01T00:00:00Z",
          "why",
          {number_figure("method=x", 0.1, 0.02), word_figure("noise 0.1 m, \"y\"", "null")}};
}

const std::string kGoodHead =
    "# scenario: s\n# scenario_hash: h\n# results_digest: d\n# commit: c\n# compiler: g\n"
    "# date: t\n# reason: r\n";
const std::string kGoodColumns = "table,row,column,value,tolerance\n";

std::string complaint_about(const std::string& text) {
  const TemporaryFolder folder;
  write_raw(folder / "r.csv", text);
  return user_error_of([&] { (void)read_reference(folder / "r.csv"); });
}

}  // namespace

TEST_CASE("a reference reads back as it was written, commas and quotes too") {
  const TemporaryFolder folder;
  Reference written = small_reference();
  written.figures.push_back(number_figure("z", 1.0 / 3.0, 1e-300));
  write_reference(folder / "a/b.csv", written);
  const Reference read = read_reference(folder / "a/b.csv");
  CHECK(read.figures == written.figures);
  CHECK(read.scenario == written.scenario);
  CHECK(read.scenario_hash == written.scenario_hash);
  CHECK(read.results_digest == written.results_digest);
  CHECK(read.commit == written.commit);
  CHECK(read.date == written.date);
  CHECK(read.reason == written.reason);
  write_reference(folder / "c.csv", written);
  CHECK(reference_names(folder.path()) == std::vector<std::string>{"a/b", "c"});
  CHECK(reference_names(folder / "absent").empty());
}

TEST_CASE("a reason of two lines stays one comment line") {
  const TemporaryFolder folder;
  Reference written = small_reference();
  written.reason = "first\nsecond";
  write_reference(folder / "r.csv", written);
  CHECK(read_reference(folder / "r.csv").reason == "first second");
}

TEST_CASE("a broken reference is refused at its line and column") {
  CHECK_THAT(complaint_about(kGoodColumns + "a,b,c,1,1\n"),
             Catch::Contains("r.csv:1:1: no line \"# scenario: "));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns), Catch::Contains("no rows"));
  CHECK_THAT(complaint_about(kGoodHead + "table,row,columns,value,tolerance\na,b,c,1,1\n"),
             Catch::Contains("r.csv:8:11: column 'columns'"));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns + "a,b,c,one,1\n"),
             Catch::Contains("r.csv:9:7: column 'value': 'one' is not a number"));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns + "a,b,c,1,-1\n"),
             Catch::Contains("r.csv:9:9: column 'tolerance': '-1' is below 0"));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns + "a,b,c,1,nan\n"),
             Catch::Contains("r.csv:9:9: column 'tolerance'"));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns + "a,b,c,1\n"),
             Catch::Contains("r.csv:9:7: 4 cells, not 5"));
  CHECK_THAT(complaint_about(kGoodHead + kGoodColumns + "a,b,c,1,1\na,b,c,2,1\n"),
             Catch::Contains("r.csv:10:1: this figure stands further up"));
}

TEST_CASE("figures within their tolerance agree, the bound included") {
  const std::vector<CheckFigure> reference = {number_figure("x", 1.0, 0.5), word_figure("x", "ok")};
  const auto compared = [&](double now, const std::string& word) {
    return compare_figures(reference, {number_figure("x", now, 0.0), word_figure("x", word)});
  };
  CHECK(compared(1.0, "ok").outside.empty());
  CHECK(compared(1.5, "ok").outside.empty());
  CHECK(compared(0.5, "ok").outside.empty());
  CHECK(compared(1.500001, "ok").outside.size() == 1);
  CHECK(compared(0.499999, "ok").outside.size() == 1);
  CHECK(compared(1.0, "worse").outside.size() == 1);
  CHECK(compared(1.0, "ok").figures == 2);
}

TEST_CASE("what is gone differs, what is new is counted, a number is no word") {
  const std::vector<CheckFigure> reference = {number_figure("x", 1.0, 0.5),
                                              word_figure("x", "null")};
  const auto gone = compare_figures(reference, {number_figure("y", 1.0, 0.5)});
  REQUIRE(gone.outside.size() == 2);
  CHECK(gone.outside[0].now == "not there");
  CHECK(gone.added == 1);
  CHECK_THAT(differences_text(gone.outside), Catch::Contains("table1, x: rate"));
  CheckFigure number = word_figure("x", "");
  number.number = 3.0;
  const auto appeared = compare_figures({word_figure("x", "null")}, {number});
  REQUIRE(appeared.outside.size() == 1);
  CHECK(appeared.outside[0].now == "3");
}

TEST_CASE("a trajectory may come nearer to the truth, not stray farther") {
  const std::vector<CheckFigure> reference = {number_figure("x", 1.0, 0.25, "trajectory")};
  const auto differs = [&](double now) {
    return !compare_figures(reference, {number_figure("x", now, 0.0, "trajectory")})
                .outside.empty();
  };
  CHECK_FALSE(differs(0.1));
  CHECK_FALSE(differs(1.25));
  CHECK(differs(1.26));
}
