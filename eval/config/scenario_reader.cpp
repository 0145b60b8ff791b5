#include "eval/config/scenario_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "algo/types/user_error.h"
#include "eval/config/key_table.h"

namespace honka::eval {
namespace {

std::string range_text(Range range, std::string_view unit) {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  if (std::isinf(range.high)) return fmt::format("at least {}{}", range.low, suffix);
  if (std::isinf(range.low)) return fmt::format("at most {}{}", range.high, suffix);
  return fmt::format("between {} and {}{}", range.low, range.high, suffix);
}

void check_range(double value, Range range, const std::string& key, std::string_view unit,
                 const std::string& place) {
  if (std::isfinite(value) && value >= range.low && value <= range.high) return;
  throw UserError(fmt::format("{}: {} = {} is out of range; it must be {}", place, key, value,
                              range_text(range, unit)));
}

[[noreturn]] void wrong_kind(const LocatedValue& given, const std::string& key,
                             std::string_view wanted) {
  throw UserError(fmt::format("{}: {} must be {}, not {} ({})", given.place, key, wanted,
                              kind_of(given.value), format_value(given.value)));
}

}  // namespace

const LocatedValue* ScenarioReader::take(const Field& field) {
  known_.push_back(prefix_ + std::string(field.key));
  const auto it = values_.find(known_.back());
  return it == values_.end() ? nullptr : &it->second;
}

void ScenarioReader::field(const Field& field, double& value, Range range) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  if (const auto* integer = std::get_if<std::int64_t>(&given->value)) {
    value = static_cast<double>(*integer);
  } else if (const auto* number = std::get_if<double>(&given->value)) {
    value = *number;
  } else {
    wrong_kind(*given, known_.back(), "a number");
  }
  check_range(value, range, known_.back(), field.unit, given->place);
}

void ScenarioReader::field(const Field& field, std::int64_t& value, Range range) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  const auto* integer = std::get_if<std::int64_t>(&given->value);
  if (integer == nullptr) wrong_kind(*given, known_.back(), "a whole number");
  value = *integer;
  check_range(static_cast<double>(value), range, known_.back(), field.unit, given->place);
}

void ScenarioReader::field(const Field& field, bool& value) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  const auto* boolean = std::get_if<bool>(&given->value);
  if (boolean == nullptr) wrong_kind(*given, known_.back(), "true or false");
  value = *boolean;
}

void ScenarioReader::field(const Field& field, std::string& value, const Choices& choices) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  const auto* text = std::get_if<std::string>(&given->value);
  if (text == nullptr) wrong_kind(*given, known_.back(), "a text");
  value = *text;
  if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  const std::string near = nearest_word(value, choices);
  throw UserError(fmt::format(
      "{}: {} = \"{}\" is not known{}; it may be {}", given->place, known_.back(), value,
      near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near), fmt::join(choices, ", ")));
}

void ScenarioReader::field(const Field& field, std::vector<double>& value, Range range) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&given->value)) {
    value.assign(integers->begin(), integers->end());
  } else if (const auto* numbers = std::get_if<std::vector<double>>(&given->value)) {
    value = *numbers;
  } else {
    wrong_kind(*given, known_.back(), "a list of numbers");
  }
  for (const double x : value) check_range(x, range, known_.back(), field.unit, given->place);
}

void ScenarioReader::field(const Field& field, std::vector<std::int64_t>& value, Range range) {
  const LocatedValue* given = take(field);
  if (given == nullptr) return;
  const auto* integers = std::get_if<std::vector<std::int64_t>>(&given->value);
  if (integers == nullptr) wrong_kind(*given, known_.back(), "a list of whole numbers");
  value = *integers;
  for (const std::int64_t x : value) {
    check_range(static_cast<double>(x), range, known_.back(), field.unit, given->place);
  }
}

void ScenarioReader::group(std::string_view name, const std::function<void()>& fields) {
  const std::string outer = prefix_;
  prefix_ += std::string(name) + ".";
  fields();
  prefix_ = outer;
}

void ScenarioReader::check_all_read() const {
  for (const auto& [key, given] : values_) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string near = nearest_word(key, known_);
    throw UserError(fmt::format("{}: unknown key {}{}; `honka scenario show FILE` lists every key",
                                given.place, key,
                                near.empty() ? "" : fmt::format("; did you mean {}?", near)));
  }
}

}  // namespace honka::eval
