#include "eval/study/study_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "eval/report/summary.h"
#include "eval/run/scenario_json.h"
#include "eval/study/study_figures.h"
#include "eval/study/study_json.h"
#include "eval/study/study_protocol.h"
#include "eval/study/study_tables.h"
#include "eval/study/study_worst.h"

namespace honka::eval {
namespace {

/// Takes away what an earlier merge drew, so that no figure is of other trials than the rest.
void clear_figures(const std::filesystem::path& figures) {
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(figures, missing)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".svg" || extension == ".png" || extension == ".gp" || extension == ".dat") {
      std::filesystem::remove(entry.path());
    }
  }
}

/// "3 of 800 trials failed (2 timed_out, 1 threw) …"; empty where none did.
std::string failures_note(const StudySummary& summary) {
  std::map<std::string, std::int64_t> failed_by;
  std::int64_t failed = 0, all = 0;
  for (const CellSummary& cell : summary.cells) {
    if (cell.method != 0) continue;  // a trial fails for all methods at once
    for (const auto& [status, count] : cell.failed_by) failed_by[status] += count;
    failed += cell.failed();
    all += cell.trials;
  }
  if (failed == 0) return "";
  std::vector<std::string> causes;
  for (const auto& [status, count] : failed_by) {
    causes.push_back(fmt::format("{} {}", count, status));
  }
  return fmt::format("{} of {} trials failed ({}); they count as 0 in every rate.", failed, all,
                     fmt::join(causes, ", "));
}

std::vector<std::string> lead_notes(const Study& study, const StudySummary& summary) {
  std::vector<std::string> notes = pooled_verdicts(study, summary);
  notes.push_back(convergence_line(study, summary.convergence));
  const std::string failures = failures_note(summary);
  if (!failures.empty()) notes.push_back(failures);
  return notes;
}

/// What varies, as a scenario says it: numbers in a list, words in one text.
std::string axes_toml(const Study& study) {
  std::string text = "\n[study.vary]\n";
  for (const StudyAxis& axis : study.axes()) {
    std::vector<std::string> values;
    bool words = false;
    for (const Value& value : axis.values) {
      const auto* word = std::get_if<std::string>(&value);
      words = words || word != nullptr || std::holds_alternative<bool>(value);
      values.push_back(word ? *word : format_value(value));
    }
    const std::string list = fmt::format("{}", fmt::join(values, ", "));
    text += words ? fmt::format("{} = \"{}\"\n", axis.key, list)
                  : fmt::format("{} = [{}]\n", axis.key, list);
  }
  return text;
}

ReportModel report_of(const Study& study, const Table& trials, const StudySummary& summary,
                      const std::vector<std::string>& protocol) {
  const Scenario& scenario = study.base.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? study.base.name : scenario.title;
  report.question = scenario.question;
  report.lead_notes = lead_notes(study, summary);
  report.tables.push_back(study_result_table(study, summary));
  if (!summary.pairs.empty()) report.tables.push_back(study_pair_table(study, summary));
  report.tables.push_back(worst_trials(study, trials));
  report.tables.push_back(study_error_table(study, summary));
  report.tables.push_back(study_cost_table(study, summary));
  report.protocol = protocol;
  report.scenario_text = to_toml(scenario) + axes_toml(study);
  return report;
}

}  // namespace

StudyOutcome write_study_results(const Study& study, const Table& trials, const Context& context,
                                 const std::filesystem::path& folder, const std::string& command) {
  const StudySummary figures_of = summarize_study(study, trials);
  const std::vector<std::string> protocol = study_protocol(study);
  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&trials});
  write_trials_h5(folder / "trials.h5", summary.context, trials, Table());
  summary.scenario = resolved_keys(study.base.scenario);
  for (const StudyAxis& axis : study.axes()) {
    Json& values = summary.scenario[fmt::format("study.vary.{}", axis.key)] = Json::array();
    for (const Value& value : axis.values) values.push_back(json_value(value));
  }
  summary.scenario_hash = study.base.hash;
  summary.tables = study_json(study, figures_of, protocol);
  summary.metrics = study_metrics(study, trials, figures_of);
  summary.report = report_of(study, trials, figures_of, protocol);
  summary.report.reproduce = command;
  clear_figures(folder / "figures");
  summary.report.figures = draw_study_figures(folder / "figures", study, figures_of);
  write_summary(folder / "summary.json", summary);
  rebuild_report(folder);
  return {study_console_text(study, figures_of), summary.results_digest};
}

}  // namespace honka::eval
