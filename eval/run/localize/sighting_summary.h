#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {

/// All lists of one case, asked of one matcher.
struct SightingSummary {
  std::string name, method;
  std::int64_t stems_in_map = 0, queries = 0;
  std::int64_t successes = 0, accepted = 0, ambiguous = 0;
  double stems = 0.0, true_stems = 0.0;                         ///< means over lists
  Interval success_interval, wrong_interval;                    ///< Wilson, 95 %
  std::optional<double> rms_error_m, rms_bound_m;               ///< of the successes
  std::optional<double> error_over_bound, rotation_over_bound;  ///< RMS over RMS, successes
  std::optional<double> error_over_stated;  ///< RMS over RMS: 1 where covariances are honest
  double time_p50_ms = 0.0, time_p95_ms = 0.0;
  double build_ms = 0.0;                            ///< median over forests
  std::optional<double> index_bytes, memory_bytes;  ///< greatest over forests

  [[nodiscard]] std::int64_t wrong() const { return accepted - successes; }
  [[nodiscard]] double share(std::int64_t count) const {
    return queries == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(queries);
  }
};

/// One summary a (case, method) in the order of first appearance in the rows of sighting_table();
/// `maps` are rows of sighting_map_table().
[[nodiscard]] std::vector<SightingSummary> summarize_sightings(const Table& maps,
                                                               const Table& lists);

}  // namespace honka::eval
