#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algo/localize/matcher.h"

namespace honka::eval {

/// A matcher over a map, and what the map cost it.
struct TimedMatcher {
  std::unique_ptr<Matcher> matcher;          ///< null where the map holds nothing to match
  double build_ms = 0.0;                     ///< graph or index, one thread
  std::optional<std::int64_t> index_bytes;   ///< of the index as a file, where there is one
  std::optional<std::int64_t> memory_bytes;  ///< held at most while it was made
};

/// UserError at an unknown method or a coordinate not finite; a map that cannot be matched gives
/// none.
[[nodiscard]] TimedMatcher make_timed_matcher(const std::string& method,
                                              const std::vector<Eigen::Vector2d>& stems_in_map_m,
                                              const LocalizeSettings& settings);

/// The matchers that variants.methods names, or localize.method alone. UserError at an unknown one.
[[nodiscard]] std::vector<std::string> methods_of(const std::string& methods,
                                                  const LocalizeSettings& settings);

}  // namespace honka::eval
