#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/run/localize/map_update_run.h"

namespace honka::eval {

/// What became of a stem of the map, or of a tree.
enum class StemFate : std::uint8_t {
  kKept,            ///< in the map, and stands
  kStale,           ///< in the map, and was felled, or never was a tree
  kRetired,         ///< taken out, and was felled
  kWronglyRetired,  ///< taken out, and stands
  kAdded,           ///< a standing tree that joined the map
  kFalselyAdded,    ///< joined the map, and no tree of its own stands there
};

/// A map against the trees that stand, within the area that the drive has seen.
struct MapQuality {
  std::string fed_by;
  std::int64_t part = 0, stems_in_map = 0, lists = 0, accepted = 0, counted = 0;
  std::int64_t felled = 0, felled_retired = 0;         ///< felled stems of the old map
  std::int64_t standing = 0, standing_retired = 0;     ///< standing stems of the old map
  std::int64_t unmapped = 0, unmapped_added = 0;       ///< standing trees not in the old map
  std::int64_t added = 0, falsely_added = 0;           ///< stems that joined
  std::int64_t seen_stems = 0, seen_true = 0;          ///< stems of the map in the area
  std::int64_t seen_trees = 0, seen_trees_mapped = 0;  ///< standing trees in the area
  std::vector<double> errors_m, added_errors_m;        ///< of true stems in the area; of added ones
  double update_ms = 0.0;
};

/// A stem with what became of it, for the picture.
struct JudgedStem {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  StemFate fate = StemFate::kKept;
  bool seen = false;  ///< in the area that the drive has seen
};

struct JudgedMap {
  MapQuality quality;
  std::vector<JudgedStem> stems;            ///< the old map's in order, then those that joined
  std::vector<Eigen::Vector2d> unmapped_m;  ///< standing trees in the area that the map lacks
};

/// Stems and trees belong together within `gate_m`, one to one. The area is what lies within the
/// updater's range and view of a list so far; before the drive, of any list of the drive.
[[nodiscard]] JudgedMap judge_map(const MapUpdateWorld& world, const MapSnapshot& snapshot,
                                  const MapUpdateSettings& updater, double gate_m);

}  // namespace honka::eval
