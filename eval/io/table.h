#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace honka::eval {

using ColumnValues =
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;

/// A named column. A missing number is NaN here and in HDF5, null in JSON.
struct Column {
  std::string name, unit, long_name;
  ColumnValues values;
  bool in_digest = true;   ///< false for times, host and paths: what differs from run to run
  std::string frame = {};  ///< coordinate frame, where the values have one ("map", "lidar")

  bool operator==(const Column&) const = default;
};

/// Columns of equal length, filled by rows. The order of the columns is the schema.
class Table {
 public:
  Table() = default;
  /// Columns may bring values; they must be of equal length.
  explicit Table(std::vector<Column> columns);

  /// Adds a column; the table must hold no rows yet, or as many as the column.
  void add_column(Column column);

  /// Appends a row given in schema order: `table.add_row(std::int64_t{3}, 0.25, "accepted")`.
  /// Integers go to double columns too; anything else that does not fit is a failed check.
  template <class... Cells>
  void add_row(const Cells&... cells) {
    std::size_t column = 0;
    check_row_width(sizeof...(cells));
    (append(column++, cells), ...);
  }
  /// Appends the rows of a table with the same schema.
  void append_rows(const Table& other);

  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  /// The column of that name; absence is a failed check.
  [[nodiscard]] const Column& column(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const;
  [[nodiscard]] const std::vector<double>& doubles(std::string_view name) const;
  [[nodiscard]] const std::vector<std::int64_t>& ints(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& strings(std::string_view name) const;

  bool operator==(const Table&) const = default;

 private:
  void check_row_width(std::size_t cells) const;
  void append(std::size_t column, double value);
  void append(std::size_t column, std::int64_t value);
  void append(std::size_t column, int value) { append(column, std::int64_t{value}); }
  void append(std::size_t column, bool value) { append(column, std::int64_t{value}); }
  void append(std::size_t column, std::size_t value) {
    append(column, static_cast<std::int64_t>(value));
  }
  void append(std::size_t column, const std::string& value);
  void append(std::size_t column, const char* value) { append(column, std::string(value)); }
  void append(std::size_t column, std::string_view value) { append(column, std::string(value)); }

  std::vector<Column> columns_;
};

/// Hex SHA-256 of some bytes.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// Hex SHA-256 over the rows of the tables, one after the other, each row's cells in schema order:
/// doubles as little-endian IEEE (−0 as 0, every NaN as one), integers as i64, strings as UTF-8
/// after their length (u64); columns with in_digest = false left out.
[[nodiscard]] std::string results_digest(const std::vector<const Table*>& tables);

/// Writes /context (attributes), /trials/<column> and /frames/<column>, with the attributes units,
/// long_name and, where given, frame. Temporary name, fsync, rename.
void write_trials_h5(const std::filesystem::path& path,
                     const std::map<std::string, std::string>& context, const Table& trials,
                     const Table& frames);

/// Reads a group of columns ("trials", "frames") in the order in which they were written.
/// UserError when the file or group is missing, truncated or foreign.
[[nodiscard]] Table read_table(const std::filesystem::path& path, const std::string& group);

/// Reads /context. Errors as above.
[[nodiscard]] std::map<std::string, std::string> read_context_h5(const std::filesystem::path& path);

}  // namespace honka::eval
