// A measured stand in place of a generated one.
#include "eval/io/csv.h"
#include "eval/io/recording.h"
#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::eval::read_table;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
using honka::test::write_tiny;

std::int64_t measured_trees(const TemporaryFolder& folder, const std::string& plot) {
  const auto outcome = run_honka({"run", "tiny.toml", "--out", "out", "-s",
                                  "forest.stem_map=" + plot, "-s", "variants.same_run=false"},
                                 folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto trials = read_table(folder / "out/trials.h5", "trials");
  CHECK(trials.ints("trees")[0] > trials.ints("measured_trees")[0]);
  return trials.ints("measured_trees")[0];
}

/// A square grid of 25 m, 5 m apart, in coordinates of a map projection.
std::string grid_csv() {
  std::string text = "# a plot\nx_m,y_m,dbh_m,height_m\n";
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) {
      text += std::to_string(500000 + 5 * i) + "," + std::to_string(6900000 + 5 * k) + ",0.21,17\n";
    }
  }
  return text;
}

}  // namespace

TEST_CASE("a measured stand stands in the middle and a generated one goes on around it") {
  const TemporaryFolder folder;
  write_tiny(folder);
  write_raw(folder / "plot.csv", grid_csv());
  const auto measured = measured_trees(folder, "plot.csv");
  // Trees on the roads of the machines are felled.
  CHECK(measured > 18);
  CHECK(measured <= 36);
}

TEST_CASE("measured stems keep their distances, diameters and heights") {
  const TemporaryFolder folder;
  write_tiny(folder);
  write_raw(folder / "plot.csv", grid_csv());
  REQUIRE(run_honka({"simulate", "tiny.toml", "--out", "drive.h5", "-s", "forest.stem_map=plot.csv",
                     "-s", "forest.trees.lean_sd_deg=0", "-s", "simulate.duration_s=0.1"},
                    folder.path())
              .exit_code == 0);
  const honka::eval::RecordingReader recording(folder / "drive.h5");
  std::vector<Eigen::Vector2d> grid_m;
  for (const auto& stem : recording.stems().stems_in_world) {
    if (stem.dbh_m == 0.21 && stem.height_m == 17.0) grid_m.push_back(stem.position_m);
  }
  REQUIRE(grid_m.size() > 18);
  for (const Eigen::Vector2d& stem : grid_m) {
    CHECK((stem - Eigen::Vector2d(30, 30)).norm() < 25);
    const Eigen::Vector2d steps = (stem - grid_m[0]) / 5.0;
    CHECK((steps - steps.array().round().matrix()).norm() < 1e-6);
  }
}

TEST_CASE("a real plot runs") {
  const auto plot = honka::test::shared("data/stem_maps/ilomantsi_p06.csv");
  if (!std::filesystem::exists(plot)) {
    WARN("skipped: " << plot << " is absent");
    return;
  }
  const TemporaryFolder folder;
  write_tiny(folder);
  const auto stems = honka::eval::read_stem_csv(plot).size();
  const auto measured = measured_trees(folder, plot.string());
  CHECK(measured > static_cast<std::int64_t>(stems / 2));
  CHECK(measured <= static_cast<std::int64_t>(stems));
}
