#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eval/report/summary.h"

namespace honka::eval {

/// One figure of a results folder: a number that may stray by its tolerance, or a word that may not
/// ("null" where there is none).
struct CheckFigure {
  std::string table;             ///< of summary.json, or "metrics", "trajectory"
  std::string row;               ///< its identifying cells: "frames=1; method=li2020"
  std::string column;            ///< "success_rate", "translation_error_m.mean"
  std::optional<double> number;  ///< nothing: `word` holds the value
  std::string word;
  double tolerance = 0.0;  ///< absolute, see tolerance.h

  bool operator==(const CheckFigure&) const = default;
};

/// The value as a reference writes it.
[[nodiscard]] std::string value_text(const CheckFigure& figure);

/// What a machine takes for its work, time and memory: never compared.
[[nodiscard]] bool is_cost(std::string_view name);

/// Every figure of tables and metrics but costs, intervals (these are tolerances) and the paper's
/// numbers, with the tolerance that its own spread gives. A row is known by the first column of
/// words and by as many columns of words, then of whole numbers, then of others, as tell the rows
/// of its table apart.
[[nodiscard]] std::vector<CheckFigure> figures_of(const Summary& summary);

}  // namespace honka::eval
