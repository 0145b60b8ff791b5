#include "eval/study/study_pairs.h"

#include <fmt/format.h>

#include "eval/report/report_model.h"
#include "eval/run/parallel.h"
#include "eval/run/thread_count.h"

namespace honka::eval {
namespace {

constexpr std::int64_t kFewestPairs = 10;  // a bootstrap of fewer is too narrow

/// The same trials by two methods.
struct SharedTrials {
  std::optional<std::int64_t> point;
  std::size_t first = 0, second = 0;  ///< methods
  std::vector<std::size_t> first_rows, second_rows;
  std::vector<std::int64_t> worlds;
};

void append_cells(SharedTrials& shared, const StudyCell& first, const StudyCell& second) {
  shared.first_rows.insert(shared.first_rows.end(), first.rows.begin(), first.rows.end());
  shared.second_rows.insert(shared.second_rows.end(), second.rows.begin(), second.rows.end());
  shared.worlds.insert(shared.worlds.end(), first.worlds.begin(), first.worlds.end());
}

/// All points together and then each, for every two methods.
std::vector<SharedTrials> shared_trials(const Study& study, const std::vector<StudyCell>& cells) {
  const std::size_t methods = study.methods.size();
  std::vector<SharedTrials> all, single;
  for (std::size_t first = 0; first < methods; ++first) {
    for (std::size_t second = first + 1; second < methods; ++second) {
      SharedTrials& pooled = all.emplace_back();
      pooled.first = first;
      pooled.second = second;
      for (std::size_t at = 0; at < cells.size(); at += methods) {
        append_cells(pooled, cells[at + first], cells[at + second]);
        SharedTrials& one = single.emplace_back();
        one.point = cells[at].point;
        one.first = first;
        one.second = second;
        append_cells(one, cells[at + first], cells[at + second]);
      }
    }
  }
  if (study.points.size() > 1) all.insert(all.end(), single.begin(), single.end());
  return all;
}

PairedFigure pair_of(const SharedTrials& shared, std::size_t measure) {
  PairedFigure pair;
  pair.point = shared.point;
  pair.measure = measure;
  pair.first = shared.first;
  pair.second = shared.second;
  pair.of = static_cast<std::int64_t>(shared.worlds.size());
  return pair;
}

/// The method that the sign of the difference speaks for.
std::optional<std::size_t> better_of(const PairedFigure& pair, bool less_is_better) {
  constexpr double kSignificant = 0.05;
  if (pair.n < kFewestPairs) return std::nullopt;
  if (!pair.interval || pair.mcnemar.value_or(0.0) >= kSignificant) return std::nullopt;
  if (pair.interval->low <= 0.0 && pair.interval->high >= 0.0) return std::nullopt;
  const bool second_is_less = *pair.difference < 0.0;
  return second_is_less == less_is_better ? pair.second : pair.first;
}

PairedFigure compare_rate(const Study& study, const Table& trials, const SharedTrials& shared,
                          std::size_t measure) {
  const Measure& what = study.kind->measures[measure];
  const auto first = outcomes(trials, what.name, shared.first_rows);
  const auto second = outcomes(trials, what.name, shared.second_rows);
  PairedFigure pair = pair_of(shared, measure);
  pair.n = pair.of;
  if (pair.n == 0) return pair;
  PairedCounts counts;
  std::vector<double> differences;
  for (std::size_t k = 0; k < first.size(); ++k) {
    differences.push_back(second[k] - first[k]);
    std::int64_t& count = first[k] == 1.0 ? (second[k] == 1.0 ? counts.both : counts.first_only)
                                          : (second[k] == 1.0 ? counts.second_only : counts.none);
    ++count;
  }
  const double n = static_cast<double>(pair.n);
  pair.first_value = static_cast<double>(counts.both + counts.first_only) / n;
  pair.second_value = static_cast<double>(counts.both + counts.second_only) / n;
  pair.difference = static_cast<double>(counts.second_only - counts.first_only) / n;
  const auto first_less_second =
      paired_rate_interval(counts, cluster_spread(differences, shared.worlds).widening);
  pair.interval = Interval{-first_less_second->high, -first_less_second->low};
  // Trials of the same number at several points are not independent.
  if (pair.point || study.points.size() == 1) pair.mcnemar = mcnemar_exact(counts);
  pair.counts = counts;
  pair.better = better_of(pair, what.less_is_better);
  return pair;
}

/// RMSE against RMSE over the trials in which both methods have the error.
std::vector<PairedFigure> compare_errors(const Study& study, const Table& trials,
                                         const SharedTrials& shared,
                                         const std::vector<std::size_t>& measures,
                                         StudyDraws& draws) {
  PooledSample sample(shared.worlds);
  std::vector<std::size_t> numbers;
  for (const std::size_t measure : measures) {
    const auto& column = trials.doubles(study.kind->measures[measure].name);
    numbers.push_back(sample.add_square_pair(taken(column, shared.second_rows),
                                             taken(column, shared.first_rows)));
  }
  sample.draw(draws);
  std::vector<PairedFigure> pairs;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    PairedFigure pair = pair_of(shared, measures[k]);
    const PooledFigure difference = sample.rms_difference(numbers[k]);
    pair.n = difference.n;
    pair.difference = difference.value;
    pair.interval = difference.interval;
    pair.second_value = sample.rms(numbers[k]).value;
    pair.first_value = sample.rms(numbers[k] + 1).value;
    pair.better = better_of(pair, study.kind->measures[measures[k]].less_is_better);
    pairs.push_back(pair);
  }
  return pairs;
}

std::string signed_text(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  if (text[0] == '-') return fmt::format("−{}", text.substr(1));
  return value > 0.0 ? fmt::format("+{}", text) : text;
}

/// "+12.5 % [8.1, 17.0], n 200"; seen from the method `from` against the other.
std::string difference_text(const Study& study, const PairedFigure& pair, std::size_t from) {
  const Measure& what = study.kind->measures[pair.measure];
  const bool rate = what.kind == MeasureKind::kRate;
  const double scale = (rate ? 100.0 : 1.0) * (from == pair.second ? 1.0 : -1.0);
  const int decimals = rate ? 1 : 4;
  std::string text = signed_text(scale * pair.difference.value_or(0.0), decimals);
  const std::string unit = rate ? "%" : what.unit;
  if (!unit.empty()) text += fmt::format(" {}", unit);
  if (pair.interval) {
    const double a = scale * pair.interval->low, b = scale * pair.interval->high;
    text += fmt::format(" [{}, {}]", signed_text(std::min(a, b), decimals),
                        signed_text(std::max(a, b), decimals));
  }
  return text + (pair.n == pair.of ? fmt::format(", n {}", pair.n)
                                   : fmt::format(", n {} of {}", pair.n, pair.of));
}

}  // namespace

std::vector<PairedFigure> compare_methods(const Study& study, const Table& trials,
                                          const std::vector<StudyCell>& cells, StudyDraws& draws) {
  const MeasuresByKind by_kind(*study.kind);
  std::vector<std::size_t> errors;
  for (const std::size_t measure : by_kind.errors) {
    if (by_kind.bound_m != measure) errors.push_back(measure);
  }
  const std::vector<SharedTrials> all = shared_trials(study, cells);
  std::vector<std::vector<PairedFigure>> found(all.size());
  for_each_index(all.size(), thread_count(0), [&](std::size_t k) {
    if (!by_kind.rates.empty()) {
      found[k].push_back(compare_rate(study, trials, all[k], by_kind.rates.front()));
    }
    if (errors.empty()) return;
    const auto compared = compare_errors(study, trials, all[k], errors, draws);
    found[k].insert(found[k].end(), compared.begin(), compared.end());
  });
  std::vector<PairedFigure> pairs;
  for (const auto& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

std::string verdict_of(const Study& study, const PairedFigure& pair) {
  const Measure& what = study.kind->measures[pair.measure];
  const std::string& first = study.methods[pair.first];
  const std::string& second = study.methods[pair.second];
  if (!pair.difference) {
    return fmt::format("{} and {}: no trial has both, n 0 of {}", first, second, pair.of);
  }
  if (!pair.better) {
    return fmt::format(
        "{} {} and {}: {}",
        pair.n < kFewestPairs ? "too few trials to tell" : "no difference seen between", first,
        second, difference_text(study, pair, pair.second));
  }
  const std::string& winner = study.methods[*pair.better];
  const std::string& other = *pair.better == pair.first ? second : first;
  std::string words = what.less_is_better ? "is lower in" : "is higher in";
  if (what.kind == MeasureKind::kError && what.less_is_better) words = "errs less in";
  const std::string claim = what.name == "success"
                                ? fmt::format("{} succeeds more often than {}", winner, other)
                                : fmt::format("{} {} {} than {}", winner, words, what.name, other);
  return fmt::format("{}: {}", claim, difference_text(study, pair, *pair.better));
}

}  // namespace honka::eval
