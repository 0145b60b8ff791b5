#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace honka::eval {

/// A cell of a text file and where it stands: line and column count from 1, in bytes.
struct Cell {
  std::string text;  ///< trimmed; quotes taken off
  std::size_t line = 0, column = 0;
};

/// A row of cells; blank lines and lines that begin with '#' are no rows.
using CellRow = std::vector<Cell>;

enum class Separator { kComma, kBlank };

/// Splits a text into rows. CRLF, a byte-order mark, and "quoted, cells" are understood.
[[nodiscard]] std::vector<CellRow> split_rows(std::string_view text, Separator separator);

/// Throws UserError "file:line:column: what".
[[noreturn]] void throw_at(const std::filesystem::path& file, const Cell& cell,
                           const std::string& what);

/// The finite number in a cell of the column `name`; UserError for anything else.
[[nodiscard]] double number_in(const std::filesystem::path& file, const Cell& cell,
                               const std::string& name);

/// The candidate nearest to a misspelt word, when it is near enough to be worth asking about.
[[nodiscard]] std::optional<std::string> did_you_mean(std::string_view word,
                                                      const std::vector<std::string>& candidates);

/// The shortest text that reads back to the same double.
[[nodiscard]] std::string exact_text(double value);

}  // namespace honka::eval
