#include "eval/run/check/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "eval/run/check/track_figures.h"

namespace honka::eval {
namespace {

bool agrees(const CheckFigure& reference, const CheckFigure& now) {
  if (!reference.number || !now.number) return value_text(reference) == value_text(now);
  const double more = *now.number - *reference.number;
  if (reference.table == kTrajectoryTable && more < 0.0) return true;
  return std::abs(more) <= reference.tolerance;
}

auto place_of(const CheckFigure& figure) {
  return std::tie(figure.table, figure.row, figure.column);
}

std::string short_number(const CheckFigure& figure) {
  return figure.number ? fmt::format("{:.6g}", *figure.number) : figure.word;
}

}  // namespace

FigureComparison compare_figures(const std::vector<CheckFigure>& reference,
                                 const std::vector<CheckFigure>& now) {
  std::map<std::tuple<std::string, std::string, std::string>, const CheckFigure*> known;
  for (const CheckFigure& figure : now) known.emplace(place_of(figure), &figure);
  FigureComparison comparison;
  comparison.figures = reference.size();
  std::size_t found = 0;
  for (const CheckFigure& figure : reference) {
    const auto it = known.find(place_of(figure));
    if (it == known.end()) {
      comparison.outside.push_back({figure, "not there"});
      continue;
    }
    ++found;
    if (!agrees(figure, *it->second)) {
      comparison.outside.push_back({figure, short_number(*it->second)});
    }
  }
  comparison.added = known.size() - found;
  return comparison;
}

std::string differences_text(const std::vector<FigureDifference>& differences) {
  std::string text =
      fmt::format("  {:>13} {:>11} {:>13}  {}\n", "reference", "tolerance", "now", "figure");
  for (const FigureDifference& difference : differences) {
    const CheckFigure& figure = difference.reference;
    const std::string tolerance = figure.number ? fmt::format("{:.3g}", figure.tolerance) : "";
    text += fmt::format("  {:>13} {:>11} {:>13}  {}, {}: {}\n", short_number(figure), tolerance,
                        difference.now, figure.table, figure.row, figure.column);
  }
  return text;
}

}  // namespace honka::eval
