#include "eval/run/slam/figure_results.h"

#include <fmt/format.h>

#include <cmath>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {
namespace {

SummaryTable facts_json(const FigureResults& results) {
  SummaryTable table;
  table.columns = {"quantity", "value", "unit"};
  for (const PaperFact& fact : results.facts) {
    Json row = {{"quantity", fact.quantity}, {"value", fact.ours}, {"unit", fact.unit}};
    if (fact.paper) row["paper"] = {{"value", *fact.paper}};
    table.rows.push_back(std::move(row));
  }
  for (const std::string& sentence : results.protocol) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

ReportTable facts_table(const std::string& title, const FigureResults& results) {
  ReportTable table;
  table.title = title;
  table.headers = {{"quantity"}, {"unit"}, {"value"}};
  for (const PaperFact& fact : results.facts) {
    ReportCell value{fact_text(fact.ours, fact.decimals)};
    if (fact.paper) {
      value.paper = fact_text(*fact.paper, fact.decimals);
      const double difference = fact.ours - *fact.paper;
      value.difference = (difference < 0.0 ? "" : "+") + fact_text(difference, fact.decimals);
    }
    table.rows.push_back({{fact.quantity}, {fact.unit}, value});
  }
  return table;
}

}  // namespace

std::string fact_text(double value, int decimals) {
  const double least = 0.5 * std::pow(10.0, -decimals);
  if (value != 0.0 && std::abs(value) < least) return fmt::format("{:.1e}", value);
  return fixed(value, decimals);
}

RunOutcome run_figure_experiment(const RunRequest& request, MakeFigures make) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const FigureResults results = make(request, folder.path() / "figures");

  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&results.rows});
  write_trials_h5(folder.path() / "trials.h5", summary.context, results.rows, Table{});
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables[results.table] = facts_json(results);
  ReportModel& report = summary.report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.lead_notes = results.notes;
  report.tables = {facts_table(report.title, results)};
  report.figures = results.figures;
  report.protocol = results.protocol;
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(report.tables.front()), request.out, summary.results_digest};
}

}  // namespace honka::eval
