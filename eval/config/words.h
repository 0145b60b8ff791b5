#pragma once

#include <string>
#include <vector>

namespace honka::eval {

/// The words of a text with commas or blanks between them.
[[nodiscard]] std::vector<std::string> words_of(const std::string& text);

}  // namespace honka::eval
