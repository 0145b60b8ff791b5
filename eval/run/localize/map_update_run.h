#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "algo/localize/map_update.h"
#include "algo/localize/matcher.h"
#include "eval/run/localize/map_update_world.h"

namespace honka::eval {

/// Parts that a drive is judged in.
inline constexpr std::int64_t kDriveParts = 4;

/// One list, asked in one map by one matcher.
struct MapUpdateAnswer {
  std::int64_t list = 0, part = 1;  ///< number along the drive; quarter of the drive, from 1
  std::string map;                  ///< old | updated | new
  std::string fed_by;               ///< matcher whose poses updated the map; empty for the others
  std::string method;
  std::int64_t stems = 0, stems_in_map = 0;
  Verdict verdict = Verdict::kTooFewStems;
  Pose2 T_map_local;
  bool success = false;
  double translation_error_m = 0.0, rotation_error_rad = 0.0;  ///< count only where accepted
  double match_ms = 0.0;

  [[nodiscard]] bool accepted() const { return verdict == Verdict::kAccepted; }
};

/// A map as it stood at the end of a part of the drive; part 0 is before the drive.
struct MapSnapshot {
  std::string fed_by;
  std::int64_t part = 0;
  std::size_t lists = 0;                   ///< of the drive so far
  std::int64_t accepted = 0, counted = 0;  ///< of these, accepted by fed_by; views that count
  MapUpdate update;
  double update_ms = 0.0;  ///< mean of an update with new matchers, one thread; 0 before the first
};

struct MapUpdateRun {
  std::vector<MapUpdateAnswer> answers;  ///< by list, then map, then method
  std::vector<MapSnapshot> snapshots;    ///< by fed_by within a part
};

/// Drives once: every list is asked of every method in the old map, in the map that each method's
/// accepted poses have updated so far, and in the new map. No truth reaches matcher or updater. The
/// digits do not depend on the number of threads. `advance` hears of so many lists done.
[[nodiscard]] MapUpdateRun run_map_update(const Scenario& scenario, const MapUpdateWorld& world,
                                          int threads,
                                          const std::function<void(std::int64_t)>& advance);

}  // namespace honka::eval
