#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/statistics.h"
#include "eval/run/localize/map_update_rows.h"

namespace honka::eval {

/// All answers of one matcher in one map after one thinning, over all drives.
struct MapUpdateSummary {
  double thinned_to_per_ha = 0.0, felled_share = 0.0;
  std::string method, map, fed_by;
  std::int64_t part = 0;  ///< quarter of the drive; 0: all of it
  double stems_in_map = 0.0;
  std::int64_t queries = 0, successes = 0, accepted = 0;
  Interval success_interval, wrong_interval;  ///< Wilson, 95 %, widened for lists of one road
  std::optional<double> rmse_m;               ///< position, of the successes
  double time_p50_ms = 0.0, time_p95_ms = 0.0;

  [[nodiscard]] std::int64_t wrong() const { return accepted - successes; }
  [[nodiscard]] double share(std::int64_t count) const {
    return queries == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(queries);
  }
  /// "old", "updated by consensus", "new".
  [[nodiscard]] std::string map_name() const {
    return fed_by.empty() ? map : map + " by " + fed_by;
  }
};

/// By thinning, method and map in the order of the answers; of each the whole drive, then its
/// parts.
[[nodiscard]] std::vector<MapUpdateSummary> summarize_answers(
    const std::vector<MapUpdateDrive>& drives);

/// Maps of one thinning and one feeding matcher at the end of a part, over all drives.
struct MapQualitySummary {
  double thinned_to_per_ha = 0.0;
  MapQuality sum;  ///< counts and errors of all drives
  std::int64_t drives = 0;
};
[[nodiscard]] std::vector<MapQualitySummary> summarize_maps(
    const std::vector<MapUpdateDrive>& drives);

}  // namespace honka::eval
