#include "eval/report/summary.h"

#include <cmath>

#include "algo/types/user_error.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/html_report.h"
#include "eval/report/report_json.h"

namespace honka::eval {
namespace {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

double number_or_nan(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json metric_json(const Metric& metric) {
  Json json = {{"value", number_or_null(metric.value)},
               {"unit", metric.unit},
               {"n", metric.n},
               {"of", metric.of},
               {"interval", nullptr},
               {"floor", nullptr}};
  if (metric.interval) {
    json["interval"] = {number_or_null((*metric.interval)[0]),
                        number_or_null((*metric.interval)[1])};
  }
  if (metric.floor) json["floor"] = number_or_null(*metric.floor);
  return json;
}

Metric metric_from(const Json& json) {
  Metric metric;
  metric.value = number_or_nan(json.at("value"));
  metric.unit = json.at("unit");
  metric.n = json.at("n");
  metric.of = json.at("of");
  if (const Json& interval = json.at("interval"); !interval.is_null()) {
    metric.interval = {{number_or_nan(interval.at(0)), number_or_nan(interval.at(1))}};
  }
  if (!json.at("floor").is_null()) metric.floor = json.at("floor").get<double>();
  return metric;
}

SummaryTable summary_table_from(const Json& json) {
  SummaryTable table;
  table.columns = json.at("columns").get<std::vector<std::string>>();
  table.rows = json.at("rows").get<std::vector<Json>>();
  table.paper = json.at("paper");
  table.protocol = json.at("protocol");
  return table;
}

Json summary_json(const Summary& summary) {
  Json json = {{"schema_version", kResultsSchemaVersion}};
  json["context"] = summary.context;
  json["scenario"] = summary.scenario;
  json["scenario_hash"] = summary.scenario_hash;
  json["results_digest"] = summary.results_digest;
  Json& tables = json["tables"] = Json::object();
  for (const auto& [name, table] : summary.tables) {
    tables[name] = {{"columns", table.columns},
                    {"rows", Json(table.rows)},
                    {"paper", table.paper},
                    {"protocol", table.protocol}};
  }
  Json& metrics = json["metrics"] = Json::object();
  for (const auto& [name, metric] : summary.metrics) metrics[name] = metric_json(metric);
  json["report"] = to_json(summary.report);
  return json;
}

Summary summary_from(const Json& json) {
  Summary summary;
  summary.context = json.at("context").get<std::map<std::string, std::string>>();
  summary.scenario = json.at("scenario");
  summary.scenario_hash = json.at("scenario_hash");
  summary.results_digest = json.at("results_digest");
  for (const auto& [name, table] : json.at("tables").items()) {
    summary.tables[name] = summary_table_from(table);
  }
  for (const auto& [name, metric] : json.at("metrics").items()) {
    summary.metrics[name] = metric_from(metric);
  }
  summary.report = report_from_json(json.at("report"));
  summary.report.context = summary.context;
  summary.report.scenario_hash = summary.scenario_hash;
  summary.report.results_digest = summary.results_digest;
  return summary;
}

/// The text of a key of the resolved scenario; empty where it has none.
std::string scenario_text_of(const Summary& summary, const std::string& key) {
  const auto value = summary.scenario.find(key);
  return value != summary.scenario.end() && value->is_string() ? value->get<std::string>() : "";
}

/// The folder of results next to this one that the scenario's key `beside` names, if it is there.
std::optional<std::filesystem::path> folder_beside(const std::filesystem::path& folder,
                                                   const Summary& summary) {
  const std::string name = scenario_text_of(summary, "beside");
  const auto other = folder.parent_path() / name;
  if (name.empty() || !std::filesystem::exists(other / "summary.json")) return std::nullopt;
  return other;
}

/// The first table of other results, with what sets them apart.
ReportTable table_of(const std::filesystem::path& folder) {
  const Summary summary = read_summary(folder / "summary.json");
  ReportTable table;
  if (!summary.report.tables.empty()) table = summary.report.tables.front();
  table.title = "Beside: " + summary.report.title;
  table.protocol =
      "odometry: " + scenario_text_of(summary, "odometry.source") + "; " + table.protocol;
  table.notes.push_back("From " + folder.filename().string() + ", digest " +
                        summary.results_digest);
  return table;
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  write_file_safely(path, summary_json(summary).dump(2) + "\n");
}

Metric rate_metric(std::int64_t n, std::int64_t of, const Interval& interval) {
  Metric metric;
  if (of > 0) metric.value = static_cast<double>(n) / static_cast<double>(of);
  metric.n = n;
  metric.of = of;
  metric.interval = {interval.low, interval.high};
  return metric;
}

Summary read_summary(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  try {
    const Json json = Json::parse(text);
    const std::int64_t version = json.at("schema_version");
    if (version > kResultsSchemaVersion) {
      throw UserError(path.string() + ": schema version " + std::to_string(version) +
                      ", this honka reads up to " + std::to_string(kResultsSchemaVersion) +
                      "; use a newer honka");
    }
    return summary_from(json);
  } catch (const Json::exception& error) {
    throw UserError(path.string() + ": not a summary that honka wrote (" + error.what() +
                    "); run the scenario again");
  }
}

void rebuild_report(const std::filesystem::path& folder) {
  Summary summary = read_summary(folder / "summary.json");
  const auto other = folder_beside(folder, summary);
  if (other) {
    const auto& tables = summary.report.tables;
    summary.report.tables.insert(tables.begin() + (tables.empty() ? 0 : 1), table_of(*other));
  }
  write_html_report(folder, summary.report);
}

void rebuild_report_beside(const std::filesystem::path& folder) {
  const auto other = folder_beside(folder, read_summary(folder / "summary.json"));
  if (other) rebuild_report(*other);
}

}  // namespace honka::eval
