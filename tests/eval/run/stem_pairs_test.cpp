// Real pairs, with made-up plots in place of the data that the project does not hold.
#include "eval/run/localize/stem_pairs.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "eval/io/csv.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// Two plots of 60 trees; each scan sees all of them from (1, -2), turned by 10 degrees.
ResolvedScenario pair_scenario(const honka::test::TemporaryFolder& folder) {
  const Pose2 T_field_scan{{1.0, -2.0}, deg_to_rad(10.0)};
  for (const std::uint64_t plot : {0, 1}) {
    RandomStream stream(5, "pair_plot", {plot});
    StemMap field, scan;
    for (int i = 0; i < 60; ++i) {
      const double x_m = stream.uniform(-20.0, 20.0);
      field.emplace_back().position_m = {x_m, stream.uniform(-20.0, 20.0)};
      scan.emplace_back().position_m = T_field_scan.inverse() * field.back().position_m;
    }
    const std::string name = "plot" + std::to_string(plot);
    write_stem_csv(folder.path() / (name + "_field.csv"), field);
    write_stem_csv(folder.path() / (name + "_tls.csv"), scan);
  }
  ResolvedScenario resolved;
  resolved.file = folder.path() / "pairs.toml";
  resolved.scenario.variants.methods = "li2020, consensus";
  resolved.scenario.localize.li2020.tolerance_m2 = 0.01;
  StemPairSettings& pairs = resolved.scenario.pairs;
  pairs.folder = folder.path().string();
  pairs.names = "plot0, plot1";
  pairs.yaw_deg = {10.0, 10.0};
  pairs.x_m = {1.0, 1.0};
  pairs.y_m = {-2.0, -2.0};
  return resolved;
}

}  // namespace

TEST_CASE("pairs are right, wrong combinations refused, by every matcher") {
  const honka::test::TemporaryFolder folder;
  const ResolvedScenario resolved = pair_scenario(folder);
  const auto rows = locate_stem_pairs(resolved.scenario, read_stem_pairs(resolved));
  REQUIRE(rows.size() == 8);
  for (const StemPairRow& row : rows) {
    CAPTURE(row.method, row.scan, row.map);
    CHECK(row.same_plot == (row.scan == row.map));
    CHECK(row.result.accepted() == row.same_plot);
    CHECK(row.success == row.same_plot);
    if (row.same_plot) CHECK(row.deviation.translation_m < 0.01);
  }
  const Table table = stem_pair_table(rows);
  CHECK(table.rows() == 8);
  CHECK(std::isnan(table.doubles("deviation_m")[1]));
}

TEST_CASE("a pair far from the brute-force answer is no success") {
  const honka::test::TemporaryFolder folder;
  ResolvedScenario resolved = pair_scenario(folder);
  resolved.scenario.pairs.x_m = {1.4, 1.0};
  for (const StemPairRow& row : locate_stem_pairs(resolved.scenario, read_stem_pairs(resolved))) {
    CHECK(row.success == (row.same_plot && row.scan == "plot1"));
  }
}

TEST_CASE("an absent folder, and places that are not as many as plots, are told in one line") {
  const honka::test::TemporaryFolder folder;
  ResolvedScenario resolved = pair_scenario(folder);
  resolved.scenario.pairs.x_m = {1.0};
  CHECK_THROWS_WITH(read_stem_pairs(resolved), Catch::Contains("give each plot one"));
  resolved.scenario.pairs.folder = "no/such/folder";
  CHECK_THROWS_WITH(read_stem_pairs(resolved), Catch::Contains("-s pairs.folder=FOLDER"));
}
