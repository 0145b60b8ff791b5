#include "eval/config/value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace honka::eval {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string with_point(double number) {
  std::string text = fmt::format("{}", number);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

struct Formatter {
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(std::int64_t n) const { return fmt::format("{}", n); }
  std::string operator()(double x) const { return with_point(x); }
  std::string operator()(const std::string& s) const { return quoted(s); }
  std::string operator()(const std::vector<double>& list) const {
    std::vector<std::string> texts;
    for (const double x : list) texts.push_back(with_point(x));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
  std::string operator()(const std::vector<std::int64_t>& list) const {
    return fmt::format("[{}]", fmt::join(list, ", "));
  }
};

}  // namespace

std::string format_value(const Value& value) { return std::visit(Formatter{}, value); }

std::string_view kind_of(const Value& value) {
  constexpr std::array<std::string_view, 6> kKinds = {
      "true or false", "a whole number",    "a number",
      "a text",        "a list of numbers", "a list of whole numbers"};
  return kKinds[value.index()];
}

}  // namespace honka::eval
