#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "algo/localize/matcher.h"
#include "eval/io/table.h"
#include "eval/metrics/localization.h"

namespace honka::eval {

/// One forest with its map and one matcher over it.
struct SightingMapRow {
  std::string name, method;
  std::int64_t trial = 0, stems_in_map = 0, queries = 0;
  double build_ms = 0.0;
  std::optional<std::int64_t> index_bytes, memory_bytes;
};

/// One stem list and what one matcher said of it.
struct SightingRow {
  std::string name, method;  ///< of the case, of the matcher
  std::int64_t trial = 0, query = 0, stems_in_map = 0;
  std::int64_t stems = 0, true_stems = 0;  ///< in the list; of these, standing in the map
  LocateResult result;
  std::optional<Pose2> T_map_sensor;  ///< truth; nothing for a list from elsewhere
  PoseError error;                    ///< of the answer; counts only where accepted
  bool success = false;
  std::optional<PoseBound> bound;
  double match_ms = 0.0;
};

/// The empty tables of /trials and /frames; their columns are the schema.
[[nodiscard]] Table sighting_map_table();
[[nodiscard]] Table sighting_table();

void append(Table& table, const SightingMapRow& row);
/// Errors of refused answers become NaN (missing).
void append(Table& table, const SightingRow& row);

}  // namespace honka::eval
