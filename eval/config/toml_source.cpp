#include "eval/config/toml_source.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

std::string place_of(const std::string& file, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", file, region.begin.line, region.begin.column);
}

Value list_value(const toml::array& array, const std::string& place) {
  std::vector<double> numbers;
  std::vector<std::int64_t> integers;
  for (const auto& element : array) {
    if (const auto integer = element.value_exact<std::int64_t>()) {
      integers.push_back(*integer);
      numbers.push_back(static_cast<double>(*integer));
    } else if (const auto number = element.value_exact<double>()) {
      numbers.push_back(*number);
    } else {
      throw UserError(place + ": a list may hold numbers only; write [1, 3, 5]");
    }
  }
  if (integers.size() == numbers.size()) return integers;
  return numbers;
}

Value value_of(const toml::node& node, const std::string& place) {
  if (const auto* array = node.as_array()) return list_value(*array, place);
  if (const auto boolean = node.value_exact<bool>()) return *boolean;
  if (const auto integer = node.value_exact<std::int64_t>()) return *integer;
  if (const auto number = node.value_exact<double>()) return *number;
  if (const auto text = node.value_exact<std::string>()) return *text;
  throw UserError(place + ": dates and times are no settings; give a number, a text or a list");
}

void collect(const toml::table& table, const std::string& prefix, const std::string& file,
             LocatedValues& values) {
  for (const auto& [key, node] : table) {
    const std::string full_key = prefix + std::string(key.str());
    if (const auto* inner = node.as_table()) {
      collect(*inner, full_key + ".", file, values);
      continue;
    }
    const toml::source_position begin = key.source().begin;
    values[full_key] = {value_of(node, place_of(file, node.source())), place_of(file, key.source()),
                        static_cast<int>(begin.line), static_cast<int>(begin.column)};
  }
}

}  // namespace

LocatedValues read_toml(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw UserError(file.string() +
                    ": no such scenario file; `ls scenarios` shows those that ship with honka");
  }
  LocatedValues values;
  try {
    const toml::table table = toml::parse_file(file.string());
    collect(table, "", file.string(), values);
  } catch (const toml::parse_error& error) {
    throw UserError(fmt::format(
        "{}: {}; write key = value, texts in quotes, lists as [1, 3], groups as [forest]",
        place_of(file.string(), error.source()), error.description()));
  }
  return values;
}

std::pair<std::string, LocatedValue> parse_override(const std::string& text) {
  const std::string place = "-s " + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UserError(place + ": write -s key=value, for example -s forest.density_per_ha=500");
  }
  const std::string key = text.substr(0, equals);
  const std::string value = text.substr(equals + 1);
  try {
    const toml::table table = toml::parse("v = " + value);
    return {key, {value_of(*table.get("v"), place), place, 0, 0}};
  } catch (const toml::parse_error&) {
    return {key, {value, place, 0, 0}};
  }
}

}  // namespace honka::eval
