#include "eval/run/localize/sighting_trial.h"

#include <algorithm>
#include <cmath>

#include "algo/types/random.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/parallel.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {
namespace {

/// Bound of the pose from the listed stems that are in the map, and the noise of both, which the
/// simulation knows. Matchers never see it.
std::optional<PoseBound> bound_of(const SightingCase& one, const sim::MappedForest& forest,
                                  const SightingQuery& query, std::int64_t& true_stems) {
  std::vector<Eigen::Vector2d> in_map;
  for (std::size_t k = 0; k < query.list.trees.size(); ++k) {
    const std::int32_t tree = query.list.trees[k];
    if (tree < 0 || forest.in_map[static_cast<std::size_t>(tree)] == 0) continue;
    in_map.push_back(query.T_world_sensor.inverse() *
                     forest.trees_m[static_cast<std::size_t>(tree)]);
  }
  true_stems = static_cast<std::int64_t>(in_map.size());
  const double sigma_m = std::hypot(one.detector.noise_m, one.map.noise_m);
  if (sigma_m <= 0.0) return std::nullopt;
  return cramer_rao_bound(in_map, sigma_m);
}

void judge_row(SightingRow& row, const SightingCase& one, const SightingWorld& world,
               const SightingQuery& query, const ProtocolSettings& protocol) {
  if (world.other) return;  // there is no truth in this map: whatever is accepted is wrong
  row.T_map_sensor = query.T_world_sensor;
  row.bound = bound_of(one, *world.mapped, query, row.true_stems);
  row.error = pose_error(row.result.T_map_local, *row.T_map_sensor);
  row.success = judge(row.result.accepted(), row.error,
                      {protocol.success_translation_m, protocol.success_rotation_deg})
                    .success();
}

std::vector<std::int64_t> numbers_of(std::int64_t queries, std::int64_t trial,
                                     std::int64_t trials) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t q = trial; q < queries; q += trials) numbers.push_back(q);
  return numbers;
}

}  // namespace

SightingWorld make_sighting_world(const Scenario& scenario, const SightingCase& one,
                                  std::int64_t trial) {
  const auto seed = static_cast<std::uint64_t>(scenario.seed);
  const auto id = static_cast<std::uint64_t>(trial);
  const auto grown = [&](const char* name) {
    return sim::make_mapped_forest(scenario.forest.spacing, scenario.forest.density_per_ha, one.map,
                                   derive_seed(seed, name, {id}));
  };
  SightingWorld world;
  world.mapped = grown("sighting_forest");
  if (scenario.sighting.elsewhere) world.other = grown("sighting_other_forest");
  world.seed = derive_seed(seed, "sighting_lists", {id});
  return world;
}

SightingQuery make_sighting_query(const Scenario& scenario, const SightingCase& one,
                                  const SightingWorld& world, std::int64_t query) {
  const auto id = static_cast<std::uint64_t>(query);
  SightingQuery result;
  result.T_world_sensor = sim::draw_pose(world.seen(), scenario.sighting.border_m, world.seed, id);
  result.list = sim::sight(world.seen(), result.T_world_sensor, one.detector, world.seed, id);
  return result;
}

SightingRow ask_sighting(const Scenario& scenario, const SightingCase& one,
                         const SightingWorld& world, const TimedMatcher& timed,
                         std::int64_t query_number) {
  const SightingQuery query = make_sighting_query(scenario, one, world, query_number);
  SightingRow row;
  row.name = one.name;
  row.query = query_number;
  row.stems_in_map = static_cast<std::int64_t>(world.mapped->map_m.size());
  row.stems = static_cast<std::int64_t>(query.list.trees.size());
  const Stopwatch watch;
  if (timed.matcher) row.result = timed.matcher->locate(query.list.stems_in_sensor_m);
  row.match_ms = watch.milliseconds();
  row.result.star_matches = {};  // only counts are kept of 1,000 answers
  judge_row(row, one, world, query, scenario.protocol);
  return row;
}

std::int64_t queries_of(const SightingCase& one, const std::string& method) {
  return method == "li2020" ? std::min(one.queries, one.li2020_queries) : one.queries;
}

SightingTrial run_sighting_trial(const Scenario& scenario, const SightingCase& one,
                                 std::int64_t trial, int threads,
                                 const std::function<void()>& advance) {
  const SightingWorld world = make_sighting_world(scenario, one, trial);
  SightingTrial done;
  // Where there is no place for the sensor, the user hears it here and not on another thread.
  static_cast<void>(make_sighting_query(scenario, one, world, trial));
  for (const std::string& method : methods_of(scenario.variants.methods, scenario.localize)) {
    const auto numbers = numbers_of(queries_of(one, method), trial, scenario.trials);
    if (numbers.empty()) continue;
    const TimedMatcher timed = make_timed_matcher(method, world.mapped->map_m, scenario.localize);
    std::vector<SightingRow> rows(numbers.size());
    for_each_index(numbers.size(), threads, [&](std::size_t i) {
      rows[i] = ask_sighting(scenario, one, world, timed, numbers[i]);
      rows[i].method = method;
      rows[i].trial = trial;
      advance();
    });
    done.maps.push_back({one.name, method, trial,
                         static_cast<std::int64_t>(world.mapped->map_m.size()),
                         static_cast<std::int64_t>(numbers.size()), timed.build_ms,
                         timed.index_bytes, timed.memory_bytes});
    done.rows.insert(done.rows.end(), rows.begin(), rows.end());
  }
  return done;
}

}  // namespace honka::eval
