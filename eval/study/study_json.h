#pragma once

#include <map>
#include <string>
#include <vector>

#include "eval/report/summary.h"
#include "eval/study/study_convergence.h"
#include "eval/study/study_pairs.h"
#include "eval/study/study_statistics.h"

namespace honka::eval {

/// All that is said of a finished study.
struct StudySummary {
  std::vector<CellSummary> cells;
  std::vector<PointCost> costs;
  std::vector<PairedFigure> pairs;
  Convergence convergence;
};

/// The summary of a study_table().
[[nodiscard]] StudySummary summarize_study(const Study& study, const Table& trials);

/// "noise" of "robustness/noise": a row a point and method; "paired"; "convergence". A number that
/// does not exist is null.
[[nodiscard]] std::map<std::string, SummaryTable> study_json(
    const Study& study, const StudySummary& summary, const std::vector<std::string>& protocol);

/// The value of a key.
[[nodiscard]] Json json_value(const Value& value);

/// Over all points together: the rates of each method, failed trials, the widest interval.
[[nodiscard]] std::map<std::string, Metric> study_metrics(const Study& study, const Table& trials,
                                                          const StudySummary& summary);

}  // namespace honka::eval
