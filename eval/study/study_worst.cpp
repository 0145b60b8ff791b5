#include "eval/study/study_worst.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "eval/study/study_statistics.h"

namespace honka::eval {
namespace {

constexpr std::size_t kOfEach = 8;  // of a kind: enough to see a pattern, few enough to run again

struct WorstTrial {
  std::size_t row = 0;
  std::string what;
  bool one_method = true;
};

/// The rate that tells of a wrong answer; where none is bad to have, the first one's absence is.
struct WrongAnswer {
  std::size_t measure = 0;
  double value = 1.0;
};

std::optional<WrongAnswer> wrong_answer(const StudyKind& kind) {
  const MeasuresByKind by_kind(kind);
  for (const std::size_t k : by_kind.rates) {
    if (kind.measures[k].less_is_better) return WrongAnswer{k, 1.0};
  }
  if (by_kind.rates.empty()) return std::nullopt;
  return WrongAnswer{by_kind.rates.front(), 0.0};
}

/// A trial fails for all methods at once, so it stands here once.
void add_failed(std::vector<WorstTrial>& worst, const Study& study, const Table& trials) {
  std::size_t found = 0;
  for (std::size_t row = 0; row < trials.rows() && found < kOfEach; ++row) {
    const std::string& status = trials.strings("status")[row];
    if (status == name_of(TrialStatus::kDone)) continue;
    if (trials.strings("method")[row] != study.methods.front()) continue;
    const std::string& cause = trials.strings("cause")[row];
    worst.push_back({row, cause.empty() ? status : fmt::format("{}: {}", status, cause), false});
    ++found;
  }
}

void add_wrong(std::vector<WorstTrial>& worst, const Study& study, const Table& trials) {
  const auto wrong = wrong_answer(*study.kind);
  if (!wrong) return;
  const std::string& name = study.kind->measures[wrong->measure].name;
  const std::vector<double>& column = trials.doubles(name);
  constexpr int kOfOneKind = 2;  // of a point and method, so that more than the first are seen
  std::map<std::pair<std::int64_t, std::string>, int> shown;
  std::size_t found = 0;
  for (std::size_t row = 0; row < trials.rows() && found < kOfEach; ++row) {
    if (column[row] != wrong->value) continue;
    if (++shown[{trials.ints("point")[row], trials.strings("method")[row]}] > kOfOneKind) continue;
    worst.push_back({row, wrong->value == 1.0 ? name : fmt::format("not {}", name)});
    ++found;
  }
}

void add_largest(std::vector<WorstTrial>& worst, const Study& study, const Table& trials) {
  const MeasuresByKind by_kind(*study.kind);
  if (by_kind.errors.empty()) return;
  const Measure& measure = study.kind->measures[by_kind.errors.front()];
  const std::vector<double>& column = trials.doubles(measure.name);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < trials.rows(); ++row) {
    if (std::isfinite(column[row])) rows.push_back(row);
  }
  const auto few = static_cast<std::ptrdiff_t>(std::min(kOfEach, rows.size()));
  std::partial_sort(rows.begin(), rows.begin() + few, rows.end(),
                    [&](std::size_t a, std::size_t b) {
                      const double x = std::abs(column[a]), y = std::abs(column[b]);
                      return x != y ? x > y : a < b;
                    });
  for (std::ptrdiff_t k = 0; k < few; ++k) {
    const std::size_t row = rows[static_cast<std::size_t>(k)];
    worst.push_back({row, fmt::format("{} {:.4g}", measure.name, column[row])});
  }
}

}  // namespace

ReportTable worst_trials(const Study& study, const Table& trials) {
  std::vector<WorstTrial> worst;
  add_failed(worst, study, trials);
  add_wrong(worst, study, trials);
  add_largest(worst, study, trials);
  ReportTable table;
  table.title = "Worst trials";
  table.protocol = fmt::format(
      "failed ones, wrong ones, the largest errors; at most {} of each, in this order", kOfEach);
  table.headers = {{"point"}, {"trial"}, {"method"}, {"what"}, {"to run it again"}};
  for (const WorstTrial& one : worst) {
    const TrialId id{trials.ints("point")[one.row], trials.ints("trial")[one.row]};
    table.rows.push_back({{point_name(study, id.point)},
                          {fmt::format("{}", id.trial)},
                          {one.one_method ? trials.strings("method")[one.row] : "all"},
                          {one.what},
                          {replay_command(study, id)}});
  }
  return table;
}

}  // namespace honka::eval
