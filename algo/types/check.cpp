#include "algo/types/check.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>

namespace honka {

void check_failed(std::string_view condition, std::string_view file, int line,
                  std::string_view message) {
  fmt::print(stderr, "{}:{}: check failed: {}: {}\n", file, line, condition, message);
  std::abort();
}

}  // namespace honka
