#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace honka::eval {

/// A cell of a table: our figure and, where the paper has one, the paper's and the difference.
struct ReportCell {
  std::string text;
  std::string paper = {}, difference = {};

  bool operator==(const ReportCell&) const = default;
};

/// Ours beside the paper's with so many decimals; the difference is ours − paper, with its sign.
[[nodiscard]] ReportCell compared(double ours, std::optional<double> paper, int decimals);

/// A number with so many decimals; "–" for NaN.
[[nodiscard]] std::string fixed(double value, int decimals);

struct ReportHeader {
  std::string name, unit = {};

  bool operator==(const ReportHeader&) const = default;
};

/// A table of the report. A column in which any cell has a paper's figure shows paper | ours |
/// difference. The protocol (definitions, thresholds, n of N) is printed with the title.
struct ReportTable {
  std::string title, protocol;
  std::vector<ReportHeader> headers;
  std::vector<std::vector<ReportCell>> rows;
  std::vector<std::string> notes;

  bool operator==(const ReportTable&) const = default;
};

/// A figure of the report. `file` is relative to the report; empty when it could not be drawn, and
/// then `notice` says why and what to do.
struct ReportFigure {
  std::string file, title, caption, notice = {};

  bool operator==(const ReportFigure&) const = default;
};

/// All that report.html shows, so that it can be made again from summary.json and figures/.
struct ReportModel {
  std::string title;
  std::string question;                 ///< what was asked
  std::vector<std::string> lead_notes;  ///< what a reader must know before the figures
  std::vector<ReportTable> tables;
  std::vector<ReportFigure> figures;
  std::vector<std::string> protocol;
  std::map<std::string, std::string> context;
  std::string scenario_text;  ///< the resolved scenario, as TOML
  std::string scenario_hash, results_digest;
  std::string reproduce;  ///< the command line

  bool operator==(const ReportModel&) const = default;
};

}  // namespace honka::eval
