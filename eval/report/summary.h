#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/statistics.h"
#include "eval/report/report_model.h"

namespace honka::eval {

/// JSON that keeps its keys in the order in which they were put in.
using Json = nlohmann::ordered_json;

/// A table of summary.json. Rows are objects; the paper's figures stand under a row's `paper`.
struct SummaryTable {
  std::vector<std::string> columns;
  std::vector<Json> rows;
  Json paper;  ///< what the paper reports, as a whole
  std::string protocol;

  bool operator==(const SummaryTable&) const = default;
};

/// A single figure with what it was taken over. NaN is written as null and read back as NaN.
struct Metric {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
  std::int64_t n = 0, of = 0;  ///< taken over n of so many
  std::optional<std::array<double, 2>> interval;
  std::optional<double> floor;  ///< the best that can be had (a bound), where known
};

/// The share that n of so many are.
[[nodiscard]] Metric rate_metric(std::int64_t n, std::int64_t of, const Interval& interval);

/// summary.json: keys as in the format's description, in full double precision.
struct Summary {
  std::map<std::string, std::string> context;
  Json scenario;  ///< resolved, every key
  std::string scenario_hash, results_digest;
  std::map<std::string, SummaryTable> tables;
  std::map<std::string, Metric> metrics;
  ReportModel report;  ///< what report.html needs beyond the above
};

/// Writes it safely. The report's context, hash and digest are taken from the summary.
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// UserError that names the file for one that is missing, no JSON, of a newer schema, or lacks or
/// mistypes a key.
[[nodiscard]] Summary read_summary(const std::filesystem::path& path);

/// Makes folder/report.html again from folder/summary.json and folder/figures/, with the first
/// table of the results that the scenario's key `beside` names, where these lie next to the folder.
/// UserError as above.
void rebuild_report(const std::filesystem::path& folder);

/// The same for the results beside `folder`, where there are any: their report then shows the new
/// rows of this one.
void rebuild_report_beside(const std::filesystem::path& folder);

}  // namespace honka::eval
