#include "eval/run/check/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

constexpr const char* kColumns[] = {"table", "row", "column", "value", "tolerance"};
constexpr std::size_t kWidth = std::size(kColumns);

/// The texts at the head of a reference, in order.
constexpr std::pair<const char*, std::string Reference::*> kHead[] = {
    {"scenario", &Reference::scenario},
    {"scenario_hash", &Reference::scenario_hash},
    {"results_digest", &Reference::results_digest},
    {"commit", &Reference::commit},
    {"compiler", &Reference::compiler},
    {"date", &Reference::date},
    {"reason", &Reference::reason},
};

void read_head(const fs::path& file, const std::string& text, Reference& reference) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    for (const auto& [key, member] : kHead) {
      const std::string begin = std::string("# ") + key + ": ";
      if (line.starts_with(begin)) reference.*member = line.substr(begin.size());
    }
  }
  for (const auto& [key, member] : kHead) {
    if (!(reference.*member).empty()) continue;
    throw UserError(file.string() + ":1:1: no line \"# " + key +
                    ": …\"; write it anew: honka check --accept NAME --why TEXT");
  }
}

void check_width(const fs::path& file, const CellRow& row) {
  if (row.size() == kWidth) return;
  throw_at(file, row.back(),
           std::to_string(row.size()) +
               " cells, not 5: table,row,column,value,tolerance; quote cells that hold a comma");
}

void check_header(const fs::path& file, const CellRow& row) {
  check_width(file, row);
  for (std::size_t i = 0; i < kWidth; ++i) {
    if (row[i].text == kColumns[i]) continue;
    throw_at(file, row[i], "column '" + row[i].text + "' stands where '" + kColumns[i] + "' must");
  }
}

CheckFigure figure_in(const fs::path& file, const CellRow& row) {
  check_width(file, row);
  CheckFigure figure{row[0].text, row[1].text, row[2].text, {}, "", 0.0};
  if (row[4].text.empty()) {
    figure.word = row[3].text;
    return figure;
  }
  figure.number = number_in(file, row[3], "value");
  figure.tolerance = number_in(file, row[4], "tolerance");
  if (figure.tolerance < 0.0) {
    throw_at(file, row[4], "column 'tolerance': '" + row[4].text + "' is below 0");
  }
  return figure;
}

/// As a cell of a CSV file on one line.
std::string cell(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

Reference read_reference(const fs::path& file) {
  const std::string text = read_text_file(file);
  Reference reference;
  read_head(file, text, reference);
  const auto rows = split_rows(text, Separator::kComma);
  if (rows.size() < 2) throw UserError(file.string() + ": no rows below the header");
  check_header(file, rows[0]);
  std::set<std::tuple<std::string, std::string, std::string>> known;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    reference.figures.push_back(figure_in(file, rows[i]));
    const CheckFigure& figure = reference.figures.back();
    if (known.emplace(figure.table, figure.row, figure.column).second) continue;
    throw_at(file, rows[i][0], "this figure stands further up already; take one of both rows out");
  }
  return reference;
}

void write_reference(const fs::path& file, const Reference& reference) {
  std::string text =
      "# Figures of a scenario's results and how far they may stray; honka check compares with "
      "them.\n";
  for (const auto& [key, member] : kHead) {
    std::string value = reference.*member;
    std::replace(value.begin(), value.end(), '\n', ' ');
    text += std::string("# ") + key + ": " + value + "\n";
  }
  text += "table,row,column,value,tolerance\n";
  for (const CheckFigure& figure : reference.figures) {
    text += cell(figure.table) + "," + cell(figure.row) + "," + cell(figure.column) + "," +
            cell(value_text(figure)) + "," +
            (figure.number ? fmt::format("{:.3g}", figure.tolerance) : "") + "\n";
  }
  write_file_safely(file, text);
}

std::vector<std::string> reference_names(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".csv") continue;
    names.push_back(fs::relative(entry.path(), folder).replace_extension().generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace honka::eval
