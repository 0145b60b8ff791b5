#pragma once

#include <string>

namespace honka::eval {

/// What the program was built from; filled in by CMake at each build.
struct BuildInfo {
  std::string commit;  ///< full hash, or "unknown" outside a git checkout
  bool dirty = false;  ///< tracked files differed from the commit
  std::string compiler, build_type, version;
};

[[nodiscard]] BuildInfo build_info();

}  // namespace honka::eval
