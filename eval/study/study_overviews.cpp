#include "eval/study/study_overviews.h"

#include <fmt/format.h>

#include "eval/study/sweep_plan.h"

namespace honka::eval {

ReportFigure draw_rate_map(const std::filesystem::path& folder, const Study& study,
                           const StudySummary& summary) {
  const SweepPlan plan = plan_sweep(study);
  const MeasuresByKind by_kind(*study.kind);
  const Measure& measure = study.kind->measures[by_kind.rates.front()];
  HeatFigure figure;
  figure.name = measure.name + "_map";
  figure.title = measure.long_name;
  figure.protocol = "percent of all trials, 95 % intervals";
  figure.x_label = plan.axis.label;
  figure.y_label = plan.curve_label;
  figure.colour_label = measure.name + " (%)";
  figure.columns = plan.columns;
  figure.rows = plan.curves;
  figure.caption = trials_text(summary.convergence) + ". One scale of colours for every method.";
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    HeatPanel& panel = figure.panels.emplace_back();
    panel.title = study.methods[method];
    for (const CellSummary& cell : summary.cells) {
      if (cell.method != method || cell.trials == 0) continue;
      const SweepPlace& place = plan.places.at(static_cast<std::size_t>(cell.point));
      const RateFigure& rate = cell.rates.front();
      panel.cells.push_back({place.column, place.curve, 100.0 * rate.rate,
                             100.0 * rate.interval.low, 100.0 * rate.interval.high});
    }
  }
  return draw_heat_map(folder, figure);
}

ReportFigure draw_convergence(const std::filesystem::path& folder, const Study& study,
                              const Convergence& convergence) {
  SweepFigure figure;
  figure.name = "convergence";
  figure.title = "How the intervals narrow";
  figure.protocol = "half of the widest 95 % interval of any point, by trials";
  figure.caption = convergence_line(study, convergence);
  figure.y_label = "half of the interval (%)";
  figure.axis.label = "trials at each point";
  figure.log_y = true;
  SweepPanel& panel = figure.panels.emplace_back();
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    SweepCurve& curve = panel.curves.emplace_back();
    curve.label = study.methods[method];
    curve.style = method;
    for (const ConvergenceFigure& one : convergence.curve) {
      if (one.method != method) continue;
      const double trials = static_cast<double>(one.trials);
      curve.points.push_back({trials, 100.0 * one.rate.half_width()});
      figure.axis.numbers.push_back(trials);
    }
  }
  return draw_sweep(folder, figure);
}

std::string trials_text(const Convergence& convergence) {
  return convergence.fewest == convergence.most
             ? fmt::format("{} trials a point", convergence.most)
             : fmt::format("{} to {} trials a point", convergence.fewest, convergence.most);
}

}  // namespace honka::eval
