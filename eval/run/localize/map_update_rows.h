#pragma once

#include <vector>

#include "eval/io/table.h"
#include "eval/run/localize/map_update_quality.h"

namespace honka::eval {

/// One drive through one thinned stand.
struct MapUpdateDrive {
  double thinned_to_per_ha = 0.0, felled_share = 0.0;
  std::int64_t trial = 0;
  std::vector<std::int64_t> road;  ///< of every list
  std::vector<MapUpdateAnswer> answers;
  std::vector<MapQuality> maps;  ///< by part, then by the matcher that fed them
};

/// /trials: one row a map at the end of a part of a drive.
[[nodiscard]] Table map_quality_rows(const std::vector<MapUpdateDrive>& drives);
/// /frames: one row an answer; errors of refused ones are NaN.
[[nodiscard]] Table map_update_answer_rows(const std::vector<MapUpdateDrive>& drives);

}  // namespace honka::eval
