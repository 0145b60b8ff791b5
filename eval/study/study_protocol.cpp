#include "eval/study/study_protocol.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/study/pooled_sample.h"
#include "eval/study/stop_rule.h"
#include "eval/study/study_statistics.h"

namespace honka::eval {
namespace {

std::string names_of(const Study& study, const std::vector<std::size_t>& measures) {
  std::vector<std::string> names;
  for (const std::size_t k : measures) {
    const Measure& measure = study.kind->measures[k];
    names.push_back(measure.unit.empty() || measure.name.ends_with(fmt::format("_{}", measure.unit))
                        ? measure.name
                        : fmt::format("{} ({})", measure.name, measure.unit));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string worlds_sentence(const Study& study) {
  const std::int64_t worlds = study.base.scenario.study.worlds;
  if (worlds >= study.trials) {
    return "No two trials of a point share a world: rates have Wilson's 95 % interval.";
  }
  return fmt::format(
      "The trials of a point share {} world(s), trial t in t mod {}. Rates have Wilson's 95 % "
      "interval, over fewer trials where worlds differ by more than chance: n trials then count as "
      "n / (d (t/z)²), with the design effect d (variance of the rate between worlds over that of "
      "independent trials) and t of Student's law, as the spread is known from {} worlds alone. A "
      "bootstrap over so few worlds would be too narrow. Where all trials came out alike, d is not "
      "known and taken as 1{}.",
      worlds, worlds, worlds, worlds == 1 ? "; one world says nothing of other worlds" : "");
}

void add_pooled(std::vector<std::string>& lines, const Study& study,
                const MeasuresByKind& by_kind) {
  if (!by_kind.errors.empty()) {
    lines.push_back(fmt::format(
        "Errors, {}: RMSE, the root of the mean square over the n trials that have one, never a "
        "mean of RMSEs. Intervals: bootstrap over trials, {} resamples, 95 %, widened as the "
        "rates' "
        "where worlds differ.",
        names_of(study, by_kind.errors), StudyDraws::kResamples));
  }
  if (by_kind.error_m) {
    lines.push_back(
        "Error over bound: RMS of translation_error_m over RMS of bound_m, the trials that have "
        "both; 1 is the least that an unbiased method can reach.");
  }
  if (!by_kind.values.empty()) {
    lines.push_back(
        fmt::format("Means over the trials that have one, {}; intervals as the errors'.",
                    names_of(study, by_kind.values)));
  }
  if (!by_kind.times.empty()) {
    lines.push_back(fmt::format(
        "Times, {}: median and 95th percentile while all workers are busy; not in the digest.",
        names_of(study, by_kind.times)));
  }
}

}  // namespace

std::vector<std::string> study_protocol(const Study& study) {
  const MeasuresByKind by_kind(*study.kind);
  const StudySettings& settings = study.base.scenario.study;
  std::vector<std::string> lines = {
      fmt::format("{} points of {} trials, each by {}. Trial t has the same world, place and noise "
                  "draws for every method, and at every point as far as what varies allows.",
                  study.points.size(), study.trials, fmt::join(study.methods, ", ")),
      fmt::format("Rates, {}: share of all trials; a failed trial (thrown, out of time or memory, "
                  "crashed) counts as 0 and stays in the denominator.",
                  names_of(study, by_kind.rates)),
      worlds_sentence(study)};
  add_pooled(lines, study, by_kind);
  if (study.methods.size() > 1) {
    lines.push_back(
        "Differences between methods are taken trial by trial: rates with Newcombe's interval for "
        "pairs (1998, method 10), errors as RMSE − RMSE over the trials in which both have one, "
        "bootstrap. A difference is called seen where it is of ten trials or more, the 95 % "
        "interval "
        "leaves out 0 and, for rates at one point, McNemar's exact p is below 0.05; of twenty "
        "points without one, one is to be "
        "expected to show it.");
  }
  if (settings.stop_half_width > 0.0) {
    lines.push_back(fmt::format(
        "A point ends after the first multiple of {} trials at which half of Wilson's interval of "
        "{} is at most {:.3g} % for every method; the one reported is wider where worlds differ.",
        kStopLook, study.kind->measures[by_kind.rates.front()].name,
        100.0 * settings.stop_half_width));
  }
  return lines;
}

}  // namespace honka::eval
