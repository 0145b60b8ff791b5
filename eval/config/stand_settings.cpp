#include "eval/config/stand_settings.h"

#include "algo/odometry/odometry.h"

namespace honka::eval {
namespace {

void describe_run(SettingsVisitor& v, bool& run) {
  v.field({"run", "", "whether the stand is driven through", "choice"}, run);
}

}  // namespace

void describe(SettingsVisitor& v, StandsSettings& s) {
  Choices odometries = {"all"};
  odometries.insert(odometries.end(), odometry_names().begin(), odometry_names().end());
  v.field({"odometries", "", "which take each stand's sweeps", "choice"}, s.odometries, odometries);
  v.field({"path_length_m", "m", "of the drive through every stand but the default",
           "choice: sub-paths of 100 m, and a run of ten minutes"},
          s.path_length_m, {5, 5000});
  v.group("default", [&] { describe_run(v, s.plain.run); });
  v.group("open", [&] {
    describe_run(v, s.open.run);
    v.field({"density_per_ha", "1/ha", "stems", "choice: seed trees and their successors"},
            s.open.density_per_ha, {1, 20000});
  });
  v.group("dense", [&] {
    describe_run(v, s.dense.run);
    v.field({"density_per_ha", "1/ha", "stems", "choice: a stand before its first thinning"},
            s.dense.density_per_ha, {1, 20000});
  });
  v.group("thinned", [&] {
    describe_run(v, s.thinned.run);
    v.field({"left_per_ha", "1/ha", "stems that a thinning of the scenario's forest leaves",
             "Li2020 2.1: 4.4 m between trees before a thinning, 8 m after it"},
            s.thinned.left_per_ha, {1, 20000});
  });
  v.group("undergrowth_rich", [&] {
    describe_run(v, s.undergrowth_rich.run);
    v.field({"bushes_per_ha", "1/ha", "bushes", "choice: one every 2.6 m"},
            s.undergrowth_rich.bushes_per_ha, {0, 1e5});
    v.field({"saplings_per_ha", "1/ha", "young trees", "choice: one every 2.6 m"},
            s.undergrowth_rich.saplings_per_ha, {0, 1e5});
  });
  v.group("steep", [&] {
    describe_run(v, s.steep.run);
    v.field({"slope_deg", "deg", "of the plane under the hills",
             "choice: steep for wheeled machines begins at a third"},
            s.steep.slope_deg, {0, 60});
  });
}

}  // namespace honka::eval
