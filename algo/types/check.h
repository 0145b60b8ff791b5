#pragma once

#include <string_view>

namespace honka {

/// Ends the program with file, line and message. A failed check is a programmer's mistake.
[[noreturn]] void check_failed(std::string_view condition, std::string_view file, int line,
                               std::string_view message);

}  // namespace honka

/// A condition the code relies on; stays in release builds.
#define HONKA_CHECK(condition, message)                                 \
  do {                                                                  \
    if (!(condition)) {                                                 \
      ::honka::check_failed(#condition, __FILE__, __LINE__, (message)); \
    }                                                                   \
  } while (false)
