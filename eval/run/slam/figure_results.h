#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/report/report_model.h"
#include "eval/report/summary.h"
#include "eval/run/experiment.h"

namespace honka::eval {

/// A figure of ours and, where the paper prints one, the paper's.
struct PaperFact {
  std::string quantity, unit;
  double ours = 0.0;
  std::optional<double> paper;
  int decimals = 2;
};

/// What an experiment that draws figures of a paper hands to its writer.
struct FigureResults {
  std::string table;  ///< name in summary.json
  std::vector<PaperFact> facts;
  std::vector<ReportFigure> figures;
  std::vector<std::string> notes, protocol;
  Table rows;  ///< of trials.h5
};

/// Works out and draws the figures into the folder given.
using MakeFigures = FigureResults (*)(const RunRequest& request,
                                      const std::filesystem::path& figures);

/// Runs an experiment of figures and writes its folder: summary.json, trials.h5, report.html.
[[nodiscard]] RunOutcome run_figure_experiment(const RunRequest& request, MakeFigures make);

/// "1.2e-15" where fixed decimals would show nothing.
[[nodiscard]] std::string fact_text(double value, int decimals);

}  // namespace honka::eval
