#include "eval/cli/locate_prior.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Nothing where the text is anything but one finite number.
std::optional<double> finite_number(const std::string& text) {
  std::string word = trimmed(text);
  if (!word.empty() && word.front() == '+') word.erase(0, 1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace

LocatePrior parse_prior(const std::string& text) {
  std::array<double, 3> numbers{};
  std::size_t count = 0, begin = 0;
  while (begin <= text.size() && count < 4) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const auto value = finite_number(text.substr(begin, comma - begin));
    if (!value || count == numbers.size()) break;
    numbers[count++] = *value;
    begin = comma + 1;
  }
  if (count != 3 || begin <= text.size() || !(numbers[2] > 0.0)) {
    throw UserError("--prior '" + text +
                    "': give x,y,radius: three numbers in metres of the map, the radius above 0, " +
                    "such as 120.5,80,50");
  }
  return {{numbers[0], numbers[1]}, numbers[2]};
}

}  // namespace honka::eval
