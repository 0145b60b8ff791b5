// Which figures of a results folder are held against a reference, their names and tolerances.
#include <catch2/catch.hpp>
#include <cmath>

#include "eval/run/check/figures.h"
#include "eval/run/check/tolerance.h"

using namespace honka::eval;

namespace {

SummaryTable table_of(const std::vector<Json>& rows) {
  SummaryTable table;
  for (const auto& item : rows.front().items()) table.columns.push_back(item.key());
  table.rows = rows;
  return table;
}

Summary summary_of(const std::vector<Json>& rows) {
  Summary summary;
  summary.tables["table1"] = table_of(rows);
  return summary;
}

const CheckFigure& figure_at(const std::vector<CheckFigure>& figures, const std::string& row,
                             const std::string& column) {
  for (const CheckFigure& figure : figures) {
    if (figure.row == row && figure.column == column) return figure;
  }
  FAIL("no figure " << row << ": " << column);
  return figures.front();
}

std::vector<std::string> names_of_rows(const std::vector<CheckFigure>& figures) {
  std::vector<std::string> names;
  for (const CheckFigure& figure : figures) {
    if (names.empty() || names.back() != figure.row) names.push_back(figure.row);
  }
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE(
    "check: rows are named by words first, then by whole numbers, as few as tell them apart") {
  const auto figures = figures_of(summary_of({
      {{"frames", 1}, {"method", "li2020"}, {"rate", 0.1}},
      {{"frames", 3}, {"method", "li2020"}, {"rate", 0.1}},
      {{"frames", 1}, {"method", "consensus"}, {"rate", 0.9}},
      {{"frames", 3}, {"method", "consensus"}, {"rate", 1.0}},
  }));
  CHECK(names_of_rows(figures) == Names{"frames=1; method=li2020", "frames=3; method=li2020",
                                        "frames=1; method=consensus",
                                        "frames=3; method=consensus"});
  CHECK(figures.size() == 4);
  const auto words_alone = figures_of(summary_of({
      {{"frames", 1}, {"method", "a; b"}, {"verdict", "same"}},
      {{"frames", 3}, {"method", "c"}, {"verdict", "worse"}},
  }));
  CHECK(names_of_rows(words_alone) == Names{"method=a, b", "method=c"});
  CHECK(figure_at(words_alone, "method=c", "verdict").word == "worse");
  CHECK_FALSE(figure_at(words_alone, "method=c", "verdict").number);
}

TEST_CASE("check: rows that nothing tells apart are counted, a single row needs no words") {
  const auto same = figures_of(summary_of({{{"a", 1.5}, {"b", nullptr}}, {{"a", 1.5}, {"b", 2}}}));
  CHECK(names_of_rows(same) == Names{"a=1.5", "a=1.5; row=2"});
  CHECK(figure_at(same, "a=1.5", "b").word == "null");
  const auto one = figures_of(summary_of({{{"blur", {{"mean", 0.5}, {"std", 0.1}}}}}));
  CHECK(names_of_rows(one) == Names{"row=1"});
  CHECK(figure_at(one, "row=1", "blur.mean").number == 0.5);
}

TEST_CASE("check: times, memory, intervals and the paper's figures are not compared") {
  Summary summary = summary_of({{{"method", "x"},
                                 {"time_ms", {{"p50", 1.0}, {"p95", 2.0}}},
                                 {"map_ms", 3.0},
                                 {"map_memory_bytes", 4.0},
                                 {"real_time_factor", 5.0},
                                 {"rate", 0.5},
                                 {"rate_interval", {0.4, 0.7}},
                                 {"paper", {{"rate", 0.6}}}}});
  summary.metrics["peak_memory"] = {30.0, "MB", 1, 1, {}, {}};
  summary.metrics["median"] = {30.0, "ms", 1, 1, {}, {}};
  summary.metrics["drift"] = {2.0, "%", 5, 5, {{1.5, 2.25}}, {}};
  summary.metrics["nothing"] = {std::nan(""), "m", 0, 5, {}, {}};
  const auto figures = figures_of(summary);
  REQUIRE(figures.size() == 3);
  CHECK(figures[0].column == "rate");
  CHECK(figures[0].tolerance == Approx(0.2));
  CHECK(figures[1].table == "metrics");
  CHECK(figures[1].row == "drift");
  CHECK(figures[1].tolerance == Approx(0.5));
  CHECK(figures[2].word == "null");
}

TEST_CASE("check: a row's interval, trials and s.d. make the tolerances of its figures") {
  const auto figures =
      figures_of(summary_of({{{"method", "x"},
                              {"windows", 500},
                              {"success_rate", 0.5},
                              {"success_interval", {0.45, 0.53}},
                              {"wrong_rate", 0.0},
                              {"refused_rate", 0.0},
                              {"error_m", {{"mean", 0.2}, {"std", 0.1}, {"max", 1.0}}},
                              {"wrong", 0},
                              {"wrong_interval", {0.0, 0.0077}},
                              {"blur", 2.0}}}));
  CHECK(figure_at(figures, "method=x", "success_rate").tolerance == Approx(0.05));
  // Wilson's interval of 0 of 500 ends at z²/(n + z²).
  const double z2 = 1.959964 * 1.959964;
  CHECK(figure_at(figures, "method=x", "refused_rate").tolerance ==
        Approx(z2 / (500 + z2)).epsilon(1e-5));
  CHECK(figure_at(figures, "method=x", "wrong_rate").tolerance == Approx(0.0077));
  CHECK(figure_at(figures, "method=x", "error_m.mean").tolerance ==
        Approx(1.96 * 0.1 / std::sqrt(250.0)));
  CHECK(figure_at(figures, "method=x", "error_m.max").tolerance == Approx(0.25));
  CHECK(figure_at(figures, "method=x", "wrong").tolerance ==
        Approx(500 * z2 / (500 + z2)).epsilon(1e-5));
  CHECK(figure_at(figures, "method=x", "windows").tolerance == Approx(25.0));
  CHECK(figure_at(figures, "method=x", "blur").tolerance == Approx(0.2));
}

TEST_CASE("check: no tolerance is 0, whatever the figure") {
  for (const double value : {0.0, 1e-12, 1.0, -5.0, 1e12}) {
    for (const char* column : {"blur", "x_rate", "x_max", "corrections"}) {
      CAPTURE(value, column);
      CHECK(tolerance_of(column, value, {}) > 0.0);
      FigureSpread narrow;
      narrow.interval = {{value, value}};
      CHECK(tolerance_of(column, value, narrow) > 0.0);
    }
  }
}
