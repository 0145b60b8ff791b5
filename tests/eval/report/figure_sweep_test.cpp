#include "eval/report/figure_sweep.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/eval/report/figure_folder.h"

using namespace honka::eval;
using honka::test::check_drawn;
using honka::test::FigureFolder;

namespace {

SweepCurve rising_curve(const std::string& label, std::size_t style,
                        const std::vector<double>& xs) {
  SweepCurve curve;
  curve.label = label;
  curve.style = style;
  for (std::size_t k = 0; k < xs.size(); ++k) {
    const double y = 20.0 + 8.0 * static_cast<double>(k + style);
    curve.points.push_back({xs[k], y, y - 5.0, y + 4.0});
  }
  return curve;
}

SweepFigure sweep_over(const std::string& name, const SweepAxis& axis, std::size_t panels) {
  SweepFigure figure;
  figure.name = name;
  figure.title = "Success";
  figure.protocol = "synthetic";
  figure.caption = "Drawn for a test.";
  figure.y_label = "share (%)";
  figure.axis = axis;
  figure.percent = true;
  std::vector<double> xs = axis.numbers;
  for (std::size_t k = 0; k < axis.words.size(); ++k) xs.push_back(static_cast<double>(k));
  for (std::size_t p = 0; p < panels; ++p) {
    figure.panels.push_back({"panel_" + std::to_string(p),
                             {rising_curve("li_2020", 0, xs), rising_curve("consensus", 1, xs)}});
  }
  return figure;
}

std::string script_of(const FigureFolder& folder, const std::string& name) {
  return read_text_file(folder.path() / (name + ".gp"));
}

}  // namespace

TEST_CASE("figures: sweep over numbers, near and far apart, and over words") {
  const FigureFolder folder;
  const SweepAxis near{"noise (m)", {0.1, 0.2, 0.3}, {}}, far{"noise (m)", {0.02, 0.1, 1.0}, {}};
  check_drawn(folder, draw_sweep(folder.path(), sweep_over("near", near, 1)), "near", "svg");
  check_drawn(folder, draw_sweep(folder.path(), sweep_over("far", far, 1)), "far", "svg");
  CHECK(script_of(folder, "near").find("logscale x") == std::string::npos);
  CHECK(script_of(folder, "far").find("logscale x") != std::string::npos);
  const SweepAxis words{"process", {}, {"rows_5%", "strauss", "a_word_of_many_letters"}};
  check_drawn(folder, draw_sweep(folder.path(), sweep_over("words", words, 2)), "words", "svg");
}

TEST_CASE("figures: a sweep leaves out what it cannot draw") {
  const FigureFolder folder;
  const SweepAxis axis{"noise (m)", {0.1, 0.2, 0.3}, {}};
  SweepFigure input = sweep_over("gaps", axis, 2);
  input.percent = false;
  input.log_y = true;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  input.panels[0].curves[0].points[1] = {0.2, kNaN, kNaN, kNaN};
  input.panels[0].curves[1].points[0] = {0.1, 0.0, 0.0, 0.0};  // has no logarithm
  for (SweepCurve& curve : input.panels[1].curves) {
    for (SweepPoint& point : curve.points) point.middle = kNaN;
  }
  check_drawn(folder, draw_sweep(folder.path(), input), "gaps", "svg");
  input.name = "nothing";
  input.panels.erase(input.panels.begin());
  CHECK(draw_sweep(folder.path(), input).notice.find("no data") != std::string::npos);
}

TEST_CASE("figures: one value on the axis") {
  const FigureFolder folder;
  for (const double x : {0.0, 0.1, -3.0}) {
    const SweepAxis axis{"noise (m)", {x}, {}};
    check_drawn(folder, draw_sweep(folder.path(), sweep_over("one", axis, 1)), "one", "svg");
  }
}

TEST_CASE("figures: heat map with a value in each cell") {
  const FigureFolder folder;
  HeatFigure input{"map",           "Success", "percent",     "Drawn for a test.",
                   "noise (m)",     "missed",  "success (%)", {"0.1", "0.2", "0.4"},
                   {"0 %", "20 %"}, {}};
  for (const char* name : {"li_2020", "consensus"}) {
    HeatPanel& panel = input.panels.emplace_back();
    panel.title = name;
    for (std::size_t k = 0; k < 5; ++k) {  // one cell has no trials
      const double percent = 100.0 - 19.0 * static_cast<double>(k);
      panel.cells.push_back({k % 3, k / 3, percent, percent - 5.0, percent});
    }
  }
  check_drawn(folder, draw_heat_map(folder.path(), input), "map", "svg");
  CHECK(script_of(folder, "map").find("with labels") != std::string::npos);
  const std::string data = read_text_file(folder.path() / "map.dat");
  CHECK(data.find("1 1 24 19 24") != std::string::npos);
}

TEST_CASE("figures: a heat map of many cells has colours alone, in a picture of bounded size") {
  const FigureFolder folder;
  HeatFigure input{"large", "Success", "percent", "Drawn for a test.", "x", "y", "%", {}, {}, {}};
  HeatPanel& panel = input.panels.emplace_back();
  panel.title = "consensus";
  for (std::size_t k = 0; k < 40; ++k) {
    input.columns.push_back(std::to_string(k));
    if (k < 30) input.rows.push_back(std::to_string(k));
  }
  for (std::size_t k = 0; k < 1200; ++k) panel.cells.push_back({k % 40, k / 40, 0.05 * double(k)});
  check_drawn(folder, draw_heat_map(folder.path(), input), "large", "svg");
  const std::string script = script_of(folder, "large");
  CHECK(script.find("with labels") == std::string::npos);
  CHECK(script.find("set terminal svg size 1198,1002 ") != std::string::npos);
}
