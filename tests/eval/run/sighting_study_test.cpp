// Localization of stem lists without rays: what is asked, how it is judged and summed up.
#include <catch2/catch.hpp>
#include <set>

#include "algo/types/user_error.h"
#include "eval/run/localize/sighting_summary.h"
#include "eval/run/localize/sighting_tables.h"
#include "eval/run/localize/sighting_trial.h"
#include "eval/run/localize/timed_matcher.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// Lists without a fault in small forests, so that both matchers find most of them.
Scenario sighting_scenario() {
  Scenario scenario;
  scenario.trials = 2;
  scenario.forest.density_per_ha = 367.0;
  scenario.variants.methods = "li2020, consensus";
  scenario.sighting.map.stems = 600;
  scenario.sighting.queries = 15;
  scenario.sighting.li2020_queries = 7;
  scenario.sighting.detector.noise_m = 0.01;
  std::get<sim::Strauss>(scenario.forest.spacing.processes).sweeps = 5;
  return scenario;
}

struct SightingTables {
  Table maps = sighting_map_table(), lists = sighting_table();
};

SightingTables run_all(const Scenario& scenario, int threads) {
  SightingTables tables;
  for (const SightingCase& one : sighting_cases(scenario.sighting)) {
    for (std::int64_t trial = 0; trial < scenario.trials; ++trial) {
      const auto done = run_sighting_trial(scenario, one, trial, threads, [] {});
      for (const auto& row : done.maps) append(tables.maps, row);
      for (const auto& row : done.rows) append(tables.lists, row);
    }
  }
  return tables;
}

}  // namespace

TEST_CASE("every list is asked once a method, and the digits do not depend on threads") {
  const Scenario scenario = sighting_scenario();
  const SightingTables one = run_all(scenario, 1), two = run_all(scenario, 2);
  CHECK(results_digest({&one.maps, &one.lists}) == results_digest({&two.maps, &two.lists}));
  std::map<std::string, std::multiset<std::int64_t>> asked;
  for (std::size_t row = 0; row < one.lists.rows(); ++row) {
    asked[one.lists.strings("method")[row]].insert(one.lists.ints("query")[row]);
    CHECK(one.lists.ints("query")[row] % 2 == one.lists.ints("trial")[row]);
  }
  CHECK(asked["consensus"] ==
        std::multiset<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14});
  CHECK(asked["li2020"] == std::multiset<std::int64_t>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("lists without a fault are found, near the bound, and the summary counts them") {
  const Scenario scenario = sighting_scenario();
  const SightingTables tables = run_all(scenario, 2);
  for (const SightingSummary& s : summarize_sightings(tables.maps, tables.lists)) {
    CAPTURE(s.method);
    CHECK(s.queries == (s.method == "li2020" ? 7 : 15));
    CHECK(s.successes == s.queries);
    CHECK(s.wrong() == 0);
    CHECK(s.stems == Approx(s.true_stems));
    REQUIRE(s.error_over_bound);
    CHECK(*s.error_over_bound > 0.5);
    CHECK(*s.error_over_bound < (s.method == "li2020" ? 10.0 : 1.6));
  }
}

TEST_CASE("what consensus states of its error is what it errs") {
  Scenario scenario = sighting_scenario();
  scenario.variants.methods = "consensus";
  scenario.sighting.queries = 60;
  scenario.sighting.detector.noise_m = 0.1;
  const SightingTables tables = run_all(scenario, 2);
  const SightingSummary s = summarize_sightings(tables.maps, tables.lists).at(0);
  REQUIRE(s.error_over_stated);
  CHECK(*s.error_over_stated > 0.75);  // the ratio of 60 lists is known to 0.07
  CHECK(*s.error_over_stated < 1.3);
  const auto& stated_m = tables.lists.doubles("stated_m");
  const auto& accepted = tables.lists.ints("accepted");
  for (std::size_t row = 0; row < tables.lists.rows(); ++row) {
    CHECK(std::isnan(stated_m[row]) == (accepted[row] == 0));
  }
}

TEST_CASE("of lists from elsewhere none can be right, and none is accepted") {
  Scenario scenario = sighting_scenario();
  scenario.sighting.elsewhere = true;
  const SightingTables tables = run_all(scenario, 2);
  for (const SightingSummary& s : summarize_sightings(tables.maps, tables.lists)) {
    CHECK(s.successes == 0);
    CHECK(s.accepted == 0);
    CHECK_FALSE(s.error_over_bound);
  }
  for (const double truth : tables.lists.doubles("true_x_m")) CHECK(std::isnan(truth));
}

TEST_CASE("the table has the keys of the interfaces, and a value for each") {
  const Scenario scenario = sighting_scenario();
  const SightingTables tables = run_all(scenario, 2);
  const SummaryTable json = sighting_json(summarize_sightings(tables.maps, tables.lists), scenario);
  REQUIRE(json.rows.size() == 2);
  for (const char* key : {"method", "frames", "stems_in_map", "success_rate", "success_interval",
                          "wrong_rate", "refused_rate", "error_over_bound", "time_ms"}) {
    CHECK(std::count(json.columns.begin(), json.columns.end(), key) == 1);
    for (const Json& row : json.rows) CHECK_FALSE(row.at(key).is_null());
  }
  CHECK(json.rows[1].at("index_bytes").get<double>() > 0.0);
  CHECK(json.rows[0].at("index_bytes").is_null());
}

TEST_CASE("cases with equal maps share the forest, a felled tree is in no list") {
  Scenario scenario = sighting_scenario();
  scenario.sighting.cases.felled_share = {0.0, 0.5};
  const auto cases = sighting_cases(scenario.sighting);
  const SightingWorld before = make_sighting_world(scenario, cases[0], 0);
  const SightingWorld after = make_sighting_world(scenario, cases[1], 0);
  CHECK(before.mapped->map_m == after.mapped->map_m);
  std::size_t listed = 0;
  for (std::int64_t q = 0; q < 5; ++q) {
    for (const std::int32_t tree : make_sighting_query(scenario, cases[1], after, q).list.trees) {
      CHECK(after.mapped->standing[static_cast<std::size_t>(tree)] != 0);
      ++listed;
    }
  }
  CHECK(listed > 50);
}

TEST_CASE("a matcher that does not exist is the user's mistake") {
  CHECK_THROWS_WITH(methods_of("li2020, stars", LocalizeSettings{}),
                    Catch::Contains("no matcher \"stars\""));
  CHECK(methods_of("", LocalizeSettings{}) == std::vector<std::string>{"li2020"});
}

TEST_CASE("a map with nothing to match gives no matcher, and its rows are refusals") {
  CHECK_FALSE(make_timed_matcher("li2020", {{0.0, 0.0}, {5.0, 0.0}}, LocalizeSettings{}).matcher);
  CHECK(make_timed_matcher("li2020", {{0, 0}, {5, 0}, {0, 5}, {5, 6}, {9, 3}, {4, 9}, {8, 8}},
                           LocalizeSettings{})
            .build_ms > 0.0);
}
