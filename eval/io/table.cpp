#include "eval/io/table.h"

#include <algorithm>
#include <limits>

#include "algo/types/check.h"

namespace honka::eval {
namespace {

std::size_t length(const Column& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

}  // namespace

Table::Table(std::vector<Column> columns) {
  for (Column& column : columns) add_column(std::move(column));
}

void Table::add_column(Column column) {
  HONKA_CHECK(columns_.empty() || length(column) == rows(),
              "columns of one table differ in length");
  HONKA_CHECK(!has(column.name), "two columns of one name: " + column.name);
  columns_.push_back(std::move(column));
}

std::size_t Table::rows() const { return columns_.empty() ? 0 : length(columns_.front()); }

bool Table::has(std::string_view name) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](const Column& column) { return column.name == name; });
}

const Column& Table::column(std::string_view name) const {
  const auto found = std::find_if(columns_.begin(), columns_.end(),
                                  [&](const Column& column) { return column.name == name; });
  HONKA_CHECK(found != columns_.end(), "no column " + std::string(name));
  return *found;
}

const std::vector<double>& Table::doubles(std::string_view name) const {
  const auto* values = std::get_if<std::vector<double>>(&column(name).values);
  HONKA_CHECK(values != nullptr, "not a column of doubles: " + std::string(name));
  return *values;
}

const std::vector<std::int64_t>& Table::ints(std::string_view name) const {
  const auto* values = std::get_if<std::vector<std::int64_t>>(&column(name).values);
  HONKA_CHECK(values != nullptr, "not a column of integers: " + std::string(name));
  return *values;
}

const std::vector<std::string>& Table::strings(std::string_view name) const {
  const auto* values = std::get_if<std::vector<std::string>>(&column(name).values);
  HONKA_CHECK(values != nullptr, "not a column of strings: " + std::string(name));
  return *values;
}

void Table::append_rows(const Table& other) {
  HONKA_CHECK(columns_.size() == other.columns_.size(), "tables of different schemas");
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    HONKA_CHECK(columns_[i].name == other.columns_[i].name &&
                    columns_[i].values.index() == other.columns_[i].values.index(),
                "tables of different schemas");
    std::visit(
        [&](auto& values) {
          using Values = std::decay_t<decltype(values)>;
          const auto& more = std::get<Values>(other.columns_[i].values);
          values.insert(values.end(), more.begin(), more.end());
        },
        columns_[i].values);
  }
}

void Table::check_row_width(std::size_t cells) const {
  HONKA_CHECK(cells == columns_.size(), "a row of another width than its table");
}

void Table::append(std::size_t column, double value) {
  auto* values = std::get_if<std::vector<double>>(&columns_[column].values);
  HONKA_CHECK(values != nullptr, "a double for column " + columns_[column].name);
  values->push_back(value);
}

void Table::append(std::size_t column, std::int64_t value) {
  if (auto* doubles = std::get_if<std::vector<double>>(&columns_[column].values)) {
    doubles->push_back(static_cast<double>(value));
    return;
  }
  auto* values = std::get_if<std::vector<std::int64_t>>(&columns_[column].values);
  HONKA_CHECK(values != nullptr, "an integer for column " + columns_[column].name);
  values->push_back(value);
}

void Table::append(std::size_t column, const std::string& value) {
  auto* values = std::get_if<std::vector<std::string>>(&columns_[column].values);
  HONKA_CHECK(values != nullptr, "a string for column " + columns_[column].name);
  values->push_back(value);
}

}  // namespace honka::eval
