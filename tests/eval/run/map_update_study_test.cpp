// Drives through a thinned stand: what is asked, what reaches the updater, how the map is judged.
#include <algorithm>
#include <catch2/catch.hpp>

#include "eval/io/table.h"
#include "eval/run/localize/map_update_rows.h"
#include "eval/run/localize/map_update_tables.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// 100 × 120 m, five strip roads, driven twice; a list each 5 m.
Scenario thinned_stand() {
  Scenario scenario;
  scenario.trials = 1;
  scenario.forest.width_m = 100.0;
  scenario.forest.length_m = 120.0;
  scenario.forest.density_per_ha = 367.0;
  std::get<sim::Strauss>(scenario.forest.spacing.processes).sweeps = 5;
  scenario.map.source = "inventory";
  scenario.map.sources.inventory.position_error_m = 0.05;
  scenario.map.sources.inventory.least_dbh_m = 0.0;
  scenario.map.sources.inventory.missed_share = 0.05;
  scenario.variants.methods = "li2020, consensus";
  scenario.map_update.view_every_m = 5.0;
  scenario.map_update.update_every = 10;
  scenario.map_update.list.missed_share = 0.1;
  scenario.map_update.list.false_share = 0.05;
  return scenario;
}

MapUpdateDrive driven(const Scenario& scenario, const MapUpdateWorld& world, int threads) {
  MapUpdateRun run = run_map_update(scenario, world, threads, [](std::int64_t) {});
  MapUpdateDrive drive;
  drive.thinned_to_per_ha = 156.0;
  drive.felled_share = world.felled_share();
  drive.road = world.road;
  for (const MapSnapshot& snapshot : run.snapshots) {
    drive.maps.push_back(judge_map(world, snapshot, scenario.map_update.updater, 0.5).quality);
  }
  drive.answers = std::move(run.answers);
  return drive;
}

const MapUpdateSummary& summary_of(const std::vector<MapUpdateSummary>& all,
                                   const std::string& method, const std::string& map_name) {
  const auto one = std::find_if(all.begin(), all.end(), [&](const MapUpdateSummary& s) {
    return s.part == 0 && s.method == method && s.map_name() == map_name;
  });
  REQUIRE(one != all.end());
  return *one;
}

/// One sensor at the origin that looks along x.
MapUpdateWorld hand_made_world() {
  MapUpdateWorld world;
  world.T_world_sensor = {{}};
  world.road = {0};
  //                       kept         felled      wrongly taken out  unmapped      behind
  world.forest.trees_m = {{10.0, 0.0}, {12.0, 5.0}, {15.0, -5.0}, {8.0, -8.0}, {-20.0, 0.0}};
  world.forest.standing = {1, 0, 1, 1, 0};
  world.old_map_m = {{10.1, 0.0}, {12.0, 5.0}, {15.0, -5.0}, {-20.0, 0.0}};
  return world;
}

}  // namespace

TEST_CASE("the machine sees what stands, from roads that are clear") {
  const Scenario scenario = thinned_stand();
  const MapUpdateWorld world = make_map_update_world(scenario, 0, 156.0);
  const sim::MappedForest& forest = world.forest;
  CHECK(world.T_world_sensor.size() == 2 * 5 * 24);
  CHECK(world.felled_share() == Approx(1.0 - 156.0 / 367.0).margin(0.01));
  const auto standing = std::count(forest.standing.begin(), forest.standing.end(), 1);
  CHECK(static_cast<std::int64_t>(world.new_map_m.size()) == standing);
  CHECK(world.old_map_m.size() < forest.trees_m.size());
  CHECK(world.old_map_m.size() > 0.9 * static_cast<double>(forest.trees_m.size()));
  for (const Eigen::Vector2d& stem : world.new_map_m) {
    // Half the width of a strip road, less what a tree leans and a map errs.
    for (const Pose2& pose : world.T_world_sensor) CHECK((pose.translation_m - stem).norm() > 1.5);
  }
  // The second pass comes back: the last pose of the first, turned about.
  const Pose2& last = world.T_world_sensor[119];
  const Pose2& next = world.T_world_sensor[120];
  CHECK((last.translation_m - next.translation_m).norm() < 1e-9);
  CHECK(std::abs(wrap_to_pi(last.yaw_rad - next.yaw_rad)) == Approx(kPi));
  CHECK(world.road[119] == world.road[120]);
}

TEST_CASE("two maps of one tree place it alike, so that maps differ in their trees alone") {
  Scenario scenario = thinned_stand();
  scenario.map.sources.inventory.missed_share = 0.0;
  const MapUpdateWorld world = make_map_update_world(scenario, 0, 156.0);
  std::size_t next = 0;
  for (const Eigen::Vector2d& stem : world.old_map_m) {
    if (next < world.new_map_m.size() && world.new_map_m[next] == stem) ++next;
  }
  CHECK(next == world.new_map_m.size());
}

TEST_CASE("a drive brings its map up to date, and the digits do not depend on threads") {
  const Scenario scenario = thinned_stand();
  const MapUpdateWorld world = make_map_update_world(scenario, 0, 156.0);
  const std::vector<MapUpdateDrive> one = {driven(scenario, world, 1)};
  const std::vector<MapUpdateDrive> two = {driven(scenario, world, 2)};
  const Table maps = map_quality_rows(one), answers = map_update_answer_rows(one);
  const Table maps2 = map_quality_rows(two), answers2 = map_update_answer_rows(two);
  CHECK(results_digest({&maps, &answers}) == results_digest({&maps2, &answers2}));
  CHECK(answers.rows() == 240 * 4 * 2);
  CHECK(maps.rows() == (1 + kDriveParts) * 2);

  const auto summaries = summarize_answers(one);
  const MapUpdateSummary& consensus = summary_of(summaries, "consensus", "updated by consensus");
  CHECK(consensus.queries == 240);
  CHECK(consensus.share(consensus.successes) > 0.9);
  CHECK(consensus.wrong() == 0);
  const auto& old = summary_of(summaries, "li2020", "old");
  const auto& updated = summary_of(summaries, "li2020", "updated by consensus");
  const auto& fresh = summary_of(summaries, "li2020", "new");
  CHECK(old.successes <= updated.successes);
  CHECK(updated.successes <= fresh.successes + 10);
  for (const MapQualitySummary& s : summarize_maps(one)) {
    if (s.sum.fed_by != "consensus") continue;
    CAPTURE(s.sum.part);
    const double precision =
        static_cast<double>(s.sum.seen_true) / static_cast<double>(s.sum.seen_stems);
    if (s.sum.part == 0) CHECK(precision < 0.5);
    if (s.sum.part == kDriveParts) CHECK(precision > 0.95);
    if (s.sum.part == kDriveParts) CHECK(s.sum.standing_retired < 0.03 * s.sum.standing);
  }
}

TEST_CASE("a map is judged by the trees that stand where the drive has seen") {
  const MapUpdateWorld world = hand_made_world();
  MapSnapshot snapshot;
  snapshot.lists = 1;
  snapshot.update.retired = {2};
  snapshot.update.stems_in_map_m = {
      {10.1, 0.0}, {12.0, 5.0}, {-20.0, 0.0}, {8.0, -8.2}, {10.2, 0.1}};
  snapshot.update.added = 2;
  const JudgedMap judged = judge_map(world, snapshot, MapUpdateSettings{}, 0.5);
  const MapQuality& q = judged.quality;
  CHECK(q.felled == 1);  // the one behind is not seen
  CHECK(q.felled_retired == 0);
  CHECK(q.standing == 2);
  CHECK(q.standing_retired == 1);
  CHECK(q.unmapped == 1);
  CHECK(q.unmapped_added == 1);
  CHECK(q.added == 2);
  CHECK(q.falsely_added == 1);  // a second stem for the tree at 10 m
  CHECK(q.seen_stems == 4);
  CHECK(q.seen_true == 2);
  CHECK(q.seen_trees == 3);
  CHECK(q.seen_trees_mapped == 2);
  REQUIRE(q.errors_m.size() == 2);
  CHECK(q.errors_m[0] == Approx(0.1));
  REQUIRE(q.added_errors_m.size() == 1);
  CHECK(q.added_errors_m[0] == Approx(0.2));
  std::vector<StemFate> fates;
  for (const JudgedStem& stem : judged.stems) fates.push_back(stem.fate);
  CHECK(fates == std::vector<StemFate>{StemFate::kKept, StemFate::kStale, StemFate::kWronglyRetired,
                                       StemFate::kStale, StemFate::kAdded,
                                       StemFate::kFalselyAdded});
  CHECK_FALSE(judged.stems[3].seen);
  CHECK(judged.unmapped_m == std::vector<Eigen::Vector2d>{{15.0, -5.0}});
}

TEST_CASE("answers are counted by map and part, and the table has the keys of the interfaces") {
  MapUpdateDrive drive;
  drive.road = {0, 0, 1, 1};
  for (std::int64_t list = 0; list < 4; ++list) {
    MapUpdateAnswer a;
    a.list = list;
    a.part = list + 1;
    a.map = "old";
    a.method = "li2020";
    a.stems_in_map = 10;
    a.verdict = list == 0 ? Verdict::kNotInMap : Verdict::kAccepted;
    a.success = list > 1;
    a.translation_error_m = 0.1 * static_cast<double>(list);
    drive.answers.push_back(a);
  }
  const auto summaries = summarize_answers({drive});
  REQUIRE(summaries.size() == 5);
  CHECK(summaries[0].queries == 4);
  CHECK(summaries[0].successes == 2);
  CHECK(summaries[0].wrong() == 1);
  CHECK(summaries[0].rmse_m.value() == Approx(std::sqrt((0.04 + 0.09) / 2.0)));
  CHECK(summaries[0].success_interval.low < 0.15);  // two roads that disagree say little
  CHECK(summaries[2].part == 2);
  CHECK(summaries[2].wrong() == 1);
  const SummaryTable json = map_update_json(summaries, thinned_stand());
  for (const char* key : {"method", "frames", "stems_in_map", "success_rate", "success_interval",
                          "wrong_rate", "refused_rate", "time_ms"}) {
    CHECK(std::count(json.columns.begin(), json.columns.end(), key) == 1);
    for (const Json& row : json.rows) CHECK_FALSE(row.at(key).is_null());
  }
}
