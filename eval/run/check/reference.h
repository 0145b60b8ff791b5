#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/run/check/figures.h"

namespace honka::eval {

/// What a scenario's results are held against: results/reference/NAME.csv.
struct Reference {
  std::string scenario;        ///< "scenarios/li2020/table1.toml"
  std::string scenario_hash;   ///< of the results that were accepted
  std::string results_digest;  ///< the same
  std::string commit, compiler, date;
  std::string reason;  ///< of the last acceptance
  std::vector<CheckFigure> figures;
};

/// Reads a reference: comment lines "# key: value" for each text above, then a header and rows
/// table,row,column,value,tolerance. UserError "file:line:column: …" for a broken row, a row that
/// stands twice, or a key that is not there.
[[nodiscard]] Reference read_reference(const std::filesystem::path& file);

/// Writes it safely; read_reference() reads the values back bit for bit, and tolerances to three
/// digits.
void write_reference(const std::filesystem::path& file, const Reference& reference);

/// Names of the references in a folder: their paths without ".csv", sorted.
[[nodiscard]] std::vector<std::string> reference_names(const std::filesystem::path& folder);

}  // namespace honka::eval
