#include "eval/io/text_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// One quoted cell that begins at `at`: "" inside stands for one quote.
std::string quoted_cell(std::string_view line, std::size_t& at) {
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] == '"') {
      if (at + 1 >= line.size() || line[at + 1] != '"') break;
      ++at;
    }
    text += line[at];
  }
  return text;
}

CellRow split_commas(std::string_view line, std::size_t number) {
  CellRow row;
  for (std::size_t at = 0; at <= line.size();) {
    while (at < line.size() && is_blank(line[at])) ++at;
    Cell cell{"", number, at + 1};
    std::size_t end = 0;
    if (at < line.size() && line[at] == '"') {
      cell.text = quoted_cell(line, at);
      end = std::min(line.find(',', at), line.size());
    } else {
      end = std::min(line.find(',', at), line.size());
      cell.text = trim(line.substr(at, end - at));
    }
    row.push_back(std::move(cell));
    at = end + 1;
  }
  return row;
}

CellRow split_blanks(std::string_view line, std::size_t number) {
  CellRow row;
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size()) break;
    std::size_t end = at;
    while (end < line.size() && !is_blank(line[end])) ++end;
    row.push_back({std::string(line.substr(at, end - at)), number, at + 1});
    at = end;
  }
  return row;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = diagonal + (std::tolower(a[i - 1]) != std::tolower(b[j - 1]));
      diagonal = row[j];
      row[j] = std::min({replace, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<CellRow> split_rows(std::string_view text, Separator separator) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<CellRow> rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view content = trim(line);
    if (content.empty() || content.front() == '#') continue;
    rows.push_back(separator == Separator::kComma ? split_commas(line, number)
                                                  : split_blanks(line, number));
  }
  return rows;
}

void throw_at(const std::filesystem::path& file, const Cell& cell, const std::string& what) {
  throw UserError(file.string() + ":" + std::to_string(cell.line) + ":" +
                  std::to_string(cell.column) + ": " + what);
}

double number_in(const std::filesystem::path& file, const Cell& cell, const std::string& name) {
  const std::string where = "column '" + name + "': ";
  if (cell.text.empty()) throw_at(file, cell, where + "empty; give a number or take the row out");
  std::string_view text = cell.text;
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw_at(file, cell, where + "'" + cell.text + "' is beyond what a double holds");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    throw_at(file, cell,
             where + "'" + cell.text + "' is not a number; use digits and a decimal point");
  }
  if (!std::isfinite(value)) {
    throw_at(file, cell,
             where + "'" + cell.text + "' is not finite; mend the number or take the row out");
  }
  return value;
}

std::optional<std::string> did_you_mean(std::string_view word,
                                        const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t best_distance = word.size() / 2 + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string exact_text(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::to_string(value);
}

}  // namespace honka::eval
