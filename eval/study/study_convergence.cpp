#include "eval/study/study_convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace honka::eval {
namespace {

/// 10, 15, 20, 30, 50, 70, 100 … and the last; even steps of a logarithmic axis.
std::vector<std::int64_t> looks_at(std::int64_t most) {
  constexpr std::array<std::int64_t, 6> kSteps = {10, 15, 20, 30, 50, 70};
  std::vector<std::int64_t> looks;
  for (std::int64_t decade = 1; decade * kSteps.front() < most; decade *= 10) {
    for (const std::int64_t step : kSteps) {
      if (decade * step < most) looks.push_back(decade * step);
    }
  }
  if (most > 0) looks.push_back(most);
  return looks;
}

/// Outcomes of the first rate and worlds of a cell, in the order of trials.
struct RateTrials {
  std::size_t method = 0;
  std::int64_t point = 0;
  std::vector<double> outcomes;
  std::vector<std::int64_t> worlds;

  [[nodiscard]] RateFigure after(std::int64_t trials) const {
    const auto n = std::min<std::ptrdiff_t>(trials, static_cast<std::ptrdiff_t>(worlds.size()));
    return rate_figure({outcomes.begin(), outcomes.begin() + n},
                       {worlds.begin(), worlds.begin() + n});
  }
};

std::optional<ConvergenceFigure> widest_of(const std::vector<RateTrials>& cells, std::size_t method,
                                           std::int64_t trials) {
  std::optional<ConvergenceFigure> widest;
  for (const RateTrials& cell : cells) {
    if (cell.method != method || cell.worlds.empty()) continue;
    const RateFigure rate = cell.after(trials);
    if (!widest || rate.half_width() > widest->rate.half_width()) {
      widest = ConvergenceFigure{trials, method, cell.point, rate};
    }
  }
  return widest;
}

/// The width of an interval goes with the root of the trials. Rounded up to two digits.
std::optional<std::int64_t> trials_wanted(const ConvergenceFigure& widest, double half_width) {
  const double ratio = widest.rate.half_width() / half_width;
  if (ratio <= 1.0) return std::nullopt;
  const double wanted = static_cast<double>(widest.rate.of) * ratio * ratio;
  const double digit = std::pow(10.0, std::max(0.0, std::floor(std::log10(wanted)) - 1.0));
  return static_cast<std::int64_t>(std::ceil(wanted / digit) * digit);
}

}  // namespace

Convergence convergence_of(const Study& study, const Table& trials,
                           const std::vector<StudyCell>& cells) {
  constexpr double kOnePercent = 0.01;
  Convergence convergence;
  const MeasuresByKind by_kind(*study.kind);
  if (by_kind.rates.empty() || cells.empty()) return convergence;
  const std::string& name = study.kind->measures[by_kind.rates.front()].name;
  std::vector<RateTrials> rates;
  convergence.fewest = static_cast<std::int64_t>(cells.front().rows.size());
  for (const StudyCell& cell : cells) {
    rates.push_back({cell.method, cell.point, outcomes(trials, name, cell.rows), cell.worlds});
    const auto n = static_cast<std::int64_t>(cell.rows.size());
    convergence.fewest = std::min(convergence.fewest, n);
    convergence.most = std::max(convergence.most, n);
  }
  for (const std::int64_t look : looks_at(convergence.most)) {
    for (std::size_t method = 0; method < study.methods.size(); ++method) {
      const auto widest = widest_of(rates, method, look);
      if (!widest) continue;
      convergence.curve.push_back(*widest);
      if (look < convergence.most) continue;
      if (!convergence.widest ||
          widest->rate.half_width() > convergence.widest->rate.half_width()) {
        convergence.widest = widest;
      }
    }
  }
  if (convergence.widest) {
    convergence.trials_for_1 = trials_wanted(*convergence.widest, kOnePercent);
  }
  return convergence;
}

std::string convergence_line(const Study& study, const Convergence& convergence) {
  if (!convergence.widest) return "No trials, so no interval.";
  const ConvergenceFigure& widest = *convergence.widest;
  const std::string where = point_name(study, widest.point);
  std::string line =
      fmt::format("±{:.1f} % after {} trials, the widest interval of {} ({}{}{})",
                  100.0 * widest.rate.half_width(), widest.rate.of,
                  study.kind->measures[MeasuresByKind(*study.kind).rates.front()].name,
                  study.methods[widest.method], where.empty() ? "" : " at ", where);
  if (convergence.trials_for_1) {
    line += fmt::format("; ±1 % wants about {} trials{}", *convergence.trials_for_1,
                        study.points.size() > 1 ? " at each point" : "");
    if (widest.rate.design_effect > 1.0) line += ", in as many more worlds";
  }
  if (convergence.fewest < convergence.most) {
    line +=
        fmt::format("; points ended after {} to {} trials", convergence.fewest, convergence.most);
  }
  return line + ".";
}

}  // namespace honka::eval
