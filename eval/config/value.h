#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace honka::eval {

/// The value of a setting.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                           std::vector<std::int64_t>>;

/// As it would stand in a scenario file; numbers with all digits that matter.
[[nodiscard]] std::string format_value(const Value& value);
/// "true or false", "a whole number", … for messages.
[[nodiscard]] std::string_view kind_of(const Value& value);

}  // namespace honka::eval
