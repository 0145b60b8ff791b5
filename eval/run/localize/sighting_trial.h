#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/localize/sighting_rows.h"
#include "eval/run/localize/timed_matcher.h"
#include "sim/sighting/sight.h"

namespace honka::eval {

/// A forest with its map and, for lists from elsewhere, the forest that they are of.
struct SightingWorld {
  std::unique_ptr<sim::MappedForest> mapped, other;
  std::uint64_t seed = 0;  ///< of the lists

  [[nodiscard]] const sim::MappedForest& seen() const { return other ? *other : *mapped; }
};

/// The digits depend on (scenario, case, trial) alone. Cases with equal maps share the forest.
[[nodiscard]] SightingWorld make_sighting_world(const Scenario& scenario, const SightingCase& one,
                                                std::int64_t trial);

/// One query of a world: where the sensor stands and what it lists.
struct SightingQuery {
  Pose2 T_world_sensor;
  sim::Sighting list;
};
[[nodiscard]] SightingQuery make_sighting_query(const Scenario& scenario, const SightingCase& one,
                                                const SightingWorld& world, std::int64_t query);

/// Asks a matcher one query and judges its answer; method and trial of the row are the caller's.
[[nodiscard]] SightingRow ask_sighting(const Scenario& scenario, const SightingCase& one,
                                       const SightingWorld& world, const TimedMatcher& timed,
                                       std::int64_t query_number);

/// Rows of one forest of a case by every method, in the order of methods, then queries.
struct SightingTrial {
  std::vector<SightingMapRow> maps;
  std::vector<SightingRow> rows;
};

/// Queries q of the case with q mod trials = trial. Each thread asks one at a time; `advance` is
/// called once a query, by one thread at a time.
[[nodiscard]] SightingTrial run_sighting_trial(const Scenario& scenario, const SightingCase& one,
                                               std::int64_t trial, int threads,
                                               const std::function<void()>& advance);

/// Queries of a case that a method is asked.
[[nodiscard]] std::int64_t queries_of(const SightingCase& one, const std::string& method);

}  // namespace honka::eval
