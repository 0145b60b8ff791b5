#pragma once

#include <algorithm>
#include <thread>

namespace honka::eval {

/// As many threads as a user asked for; 0 or less asks for one a core.
[[nodiscard]] inline int thread_count(int asked) {
  if (asked > 0) return asked;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace honka::eval
