#pragma once

#include <map>
#include <string>
#include <vector>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/experiment.h"

namespace honka::eval {

/// What an experiment on stem lists hands to its writer.
struct LocalizeResults {
  Table trials, frames;                        ///< of trials.h5
  std::map<std::string, SummaryTable> tables;  ///< of summary.json
  std::map<std::string, Metric> metrics;
  std::vector<ReportTable> report_tables;
  std::vector<ReportFigure> figures;
  std::vector<std::string> notes, protocol;
};

/// Writes summary.json, trials.h5 and report.html, and puts the folder in its place.
[[nodiscard]] RunOutcome write_localize_results(const RunRequest& request, const Context& context,
                                                OutputFolder& folder, LocalizeResults results);

/// "hard" of "localization/hard": what the scenario's table is called.
[[nodiscard]] std::string table_name_of(const ResolvedScenario& resolved);

}  // namespace honka::eval
