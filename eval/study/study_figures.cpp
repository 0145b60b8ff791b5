#include "eval/study/study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "eval/study/study_overviews.h"
#include "eval/study/sweep_plan.h"

namespace honka::eval {
namespace {

/// A figure of a cell as it is drawn; x is not set.
using CellPoint = std::function<SweepPoint(const CellSummary&)>;

/// What a figure shows of each cell, and the bound beside it.
struct DrawnQuantity {
  std::string name, title, protocol, caption, y_label;
  CellPoint value, bound;  ///< bound: empty where there is none
  bool percent = false, log_y = false, each_method = true;
};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

SweepPoint pooled_point(const PooledFigure& figure) {
  SweepPoint point;
  point.middle = figure.value.value_or(kNothing);
  if (figure.interval) {
    point.low = figure.interval->low;
    point.high = figure.interval->high;
  }
  return point;
}

/// The median, its whisker up to the 95th percentile.
SweepPoint time_point(const TimeFigure& time) {
  SweepPoint point;
  point.middle = point.low = time.p50.value_or(kNothing);
  point.high = time.p95.value_or(kNothing);
  return point;
}

bool drawn(const SweepPlan& plan, const CellSummary& cell, std::size_t slice, std::size_t curve) {
  const SweepPlace& place = plan.places.at(static_cast<std::size_t>(cell.point));
  return place.slice == slice && place.curve == curve && cell.trials > 0;
}

SweepCurve curve_of(const SweepPlan& plan, const StudySummary& summary, const CellPoint& value,
                    std::size_t method, std::size_t slice, std::size_t curve) {
  SweepCurve drawn_curve;
  for (const CellSummary& cell : summary.cells) {
    if (cell.method != method || !drawn(plan, cell, slice, curve)) continue;
    SweepPoint point = value(cell);
    point.x = plan.places.at(static_cast<std::size_t>(cell.point)).x;
    drawn_curve.points.push_back(point);
  }
  std::stable_sort(drawn_curve.points.begin(), drawn_curve.points.end(),
                   [](const SweepPoint& a, const SweepPoint& b) { return a.x < b.x; });
  return drawn_curve;
}

void add_curves(SweepPanel& panel, const SweepPlan& plan, const StudySummary& summary,
                const DrawnQuantity& what, std::size_t method, std::size_t slice,
                std::size_t number, const std::string& label) {
  const std::size_t curve = plan.two_axes() ? number : 0;
  SweepCurve main = curve_of(plan, summary, what.value, method, slice, curve);
  main.label = label;
  main.style = number;
  panel.curves.push_back(std::move(main));
  if (!what.bound) return;
  SweepCurve bound = curve_of(plan, summary, what.bound, method, slice, curve);
  if (!plan.two_axes()) bound.label = label + ", least possible";
  bound.style = number;
  bound.reference = true;
  panel.curves.push_back(std::move(bound));
}

/// One axis: one panel, a curve a method. More: a panel a method, a curve a value.
std::vector<SweepPanel> panels_of(const Study& study, const SweepPlan& plan,
                                  const StudySummary& summary, const DrawnQuantity& what,
                                  std::size_t slice) {
  const std::size_t methods = what.each_method ? study.methods.size() : 1;
  std::vector<SweepPanel> panels(plan.two_axes() ? methods : 1);
  for (std::size_t method = 0; method < methods; ++method) {
    const std::string name = what.each_method ? study.methods[method] : "all methods together";
    if (!plan.two_axes()) {
      add_curves(panels.front(), plan, summary, what, method, slice, method, name);
      continue;
    }
    panels[method].title = name;
    for (std::size_t k = 0; k < std::min(plan.curves.size(), SweepPlan::kCurves); ++k) {
      add_curves(panels[method], plan, summary, what, method, slice, k, plan.curves[k]);
    }
  }
  return panels;
}

std::string left_out(const SweepPlan& plan) {
  std::string text;
  if (plan.curves.size() > SweepPlan::kCurves) {
    text += fmt::format(" The first {} of {} values of {} are drawn.", SweepPlan::kCurves,
                        plan.curves.size(), plan.curve_label);
  }
  if (plan.slices.size() > SweepPlan::kSlices) {
    text += fmt::format(" The first {} of {} combinations of the other keys are drawn.",
                        SweepPlan::kSlices, plan.slices.size());
  }
  return text;
}

void draw_quantity(std::vector<ReportFigure>& figures, const std::filesystem::path& folder,
                   const Study& study, const StudySummary& summary, const DrawnQuantity& what) {
  const SweepPlan plan = plan_sweep(study);
  for (std::size_t slice = 0; slice < std::min(plan.slices.size(), SweepPlan::kSlices); ++slice) {
    SweepFigure figure;
    figure.name = what.name + (plan.slices.size() > 1 ? fmt::format("_{}", slice + 1) : "");
    figure.title = what.title;
    if (!plan.slices[slice].empty()) figure.title += fmt::format(", {}", plan.slices[slice]);
    figure.protocol = what.protocol;
    figure.caption = what.caption + left_out(plan);
    figure.y_label = what.y_label;
    figure.legend = plan.curve_label;
    figure.axis = plan.axis;
    figure.percent = what.percent;
    figure.log_y = what.log_y;
    figure.panels = panels_of(study, plan, summary, what, slice);
    figures.push_back(draw_sweep(folder, figure));
  }
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} ({})", text, unit);
}

DrawnQuantity drawn_rate(const Study& study, const StudySummary& summary, std::size_t measure) {
  DrawnQuantity what;
  what.name = study.kind->measures[measure].name;
  what.title = study.kind->measures[measure].long_name;
  what.protocol = trials_text(summary.convergence) + ", 95 % intervals";
  what.y_label = "share of all trials (%)";
  what.caption =
      "Every trial counts, failed ones as 0. Points are moved a little sideways so that "
      "their intervals do not hide each other.";
  what.percent = true;
  what.value = [](const CellSummary& cell) {
    const RateFigure& rate = cell.rates.front();
    return SweepPoint{0.0, 100.0 * rate.rate, 100.0 * rate.interval.low,
                      100.0 * rate.interval.high};
  };
  return what;
}

/// The k-th error.
DrawnQuantity drawn_error(const Study& study, const MeasuresByKind& by_kind, std::size_t k) {
  const Measure& measure = study.kind->measures[by_kind.errors[k]];
  DrawnQuantity what;
  what.name = measure.name;
  what.title = measure.long_name;
  what.protocol = "RMSE over the trials that have one, bootstrap intervals, 95 %";
  what.y_label = with_unit("RMSE", measure.unit);
  what.value = [k](const CellSummary& cell) { return pooled_point(cell.errors[k]); };
  what.caption = "Pooled over trials.";
  if (by_kind.error_m != by_kind.errors[k]) return what;
  std::size_t bound = 0;
  while (by_kind.errors[bound] != *by_kind.bound_m) ++bound;
  what.bound = [bound](const CellSummary& cell) { return pooled_point(cell.errors[bound]); };
  what.caption +=
      " Dashed: the RMS of the least error that an unbiased method can have "
      "(Cramér-Rao), over the same trials.";
  return what;
}

DrawnQuantity drawn_time(const Study& study, std::size_t measure) {
  DrawnQuantity what;
  what.name = study.kind->measures[measure].name;
  what.title = study.kind->measures[measure].long_name;
  what.protocol = "median, whisker to the 95th percentile; logarithmic";
  what.y_label = with_unit("time", study.kind->measures[measure].unit);
  what.value = [](const CellSummary& cell) { return time_point(cell.times.front()); };
  what.caption = "While all workers are busy.";
  what.log_y = true;
  return what;
}

/// What trials cost, all methods together.
DrawnQuantity drawn_cost(const StudySummary& summary, bool memory) {
  const auto& costs = summary.costs;
  DrawnQuantity what;
  what.each_method = false;
  what.name = memory ? "memory" : "trial_time";
  what.title = memory ? "Memory over the sweep" : "Time of a trial over the sweep";
  what.protocol = memory ? "resident pages of a worker at the end of a trial, most at the point"
                         : "median, whisker to the 95th percentile; logarithmic";
  what.y_label = memory ? "memory (MB)" : "wall time (s)";
  what.log_y = !memory;
  what.caption = memory ? "Of one worker; as many run at once as there are threads."
                        : "All methods, and the world of the trial if it had to be made.";
  what.value = [&costs, memory](const CellSummary& cell) {
    const PointCost& cost = costs.at(static_cast<std::size_t>(cell.point));
    if (!memory) return time_point(cost.wall_s);
    SweepPoint point;
    point.middle = cost.resident_mb.value_or(kNothing);
    return point;
  };
  return what;
}

bool any_error(const StudySummary& summary, std::size_t k) {
  for (const CellSummary& cell : summary.cells) {
    if (cell.errors[k].value) return true;
  }
  return false;
}

}  // namespace

std::vector<ReportFigure> draw_study_figures(const std::filesystem::path& folder,
                                             const Study& study, const StudySummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  const SweepPlan plan = plan_sweep(study);
  std::vector<ReportFigure> figures;
  const auto draw = [&](const DrawnQuantity& what) {
    draw_quantity(figures, folder, study, summary, what);
  };
  if (!by_kind.rates.empty()) {
    if (plan.two_axes() && plan.slices.size() == 1) {
      figures.push_back(draw_rate_map(folder, study, summary));
    }
    draw(drawn_rate(study, summary, by_kind.rates.front()));
  }
  for (std::size_t k = 0; k < by_kind.errors.size(); ++k) {
    if (by_kind.bound_m == by_kind.errors[k] || !any_error(summary, k)) continue;
    draw(drawn_error(study, by_kind, k));
  }
  if (summary.convergence.widest) {
    figures.push_back(draw_convergence(folder, study, summary.convergence));
  }
  if (!by_kind.times.empty()) draw(drawn_time(study, by_kind.times.front()));
  draw(drawn_cost(summary, false));
  draw(drawn_cost(summary, true));
  return figures;
}

}  // namespace honka::eval
