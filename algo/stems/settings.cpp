#include "algo/stems/extract.h"

namespace honka {
namespace {

void describe_algorithm(SettingsVisitor& v, StemSettings& s) {
  v.field({"form", "", "journal: projected, with the planar test; preprint: clusters in 3D",
           "Li2020 Algorithm 1"},
          s.form, {"journal", "preprint"});
  v.field({"height_offset_m", "m", "a trunk point has a neighbour this far above", "Li2020 t_h"},
          s.height_offset_m, {0.1, 20.0});
  v.field({"d_threshold_m", "m", "how near the spot above that neighbour must lie",
           "choice: channels are 0.7 m apart at 20 m; 0.2 and 0.5 find fewer"},
          s.d_threshold_m, {0.001, 5.0});
  v.field({"planar_radius_m", "m", "a projected point needs another this near", "Li2020 t_H"},
          s.planar_radius_m, {0.001, 5.0});
  v.field({"cluster_link_m", "m", "points nearer than this share a cluster",
           "choice: 0.5 m merges crowns"},
          s.cluster_link_m, {0.001, 5.0});
  v.field({"cluster_threshold", "", "least points of a stem",
           "choice: 5 for a local cloud, 100–500 for the map of a run"},
          s.cluster_threshold, {1, 1000000});
  v.field({"points_per_sweep", "", "and least points for each sweep that the cloud holds",
           "Li2020 section 2.4, observational stability; greatest F1 of stems in ten sweeps"},
          s.points_per_sweep, {0.0, 1000.0});
}

}  // namespace

void describe(SettingsVisitor& v, StemSettings& s) {
  describe_algorithm(v, s);
  v.field({"centre", "", "estimator of a stem's centre from its points",
           "mean: Li2020; the others: algo/stems/README.md"},
          s.centre, {"mean", "bias_corrected", "circle_fit"});
  v.field({"search", "", "kd_tree is literal; voxel_hash gives the same stems sooner", "Li2020"},
          s.search, {"kd_tree", "voxel_hash"});
  v.field({"max_range_m", "m", "points seen from farther away are dropped",
           "choice: 60 m in the map costs a fifth of the recall"},
          s.max_range_m, {1.0, 1000.0});
  v.field(
      {"voxel_m", "m", "thin to one point a voxel first; 0 keeps all", "choice: 0.025 for maps"},
      s.voxel_m, {0.0, 5.0});
  v.field({"height_band", "", "use only points in a band above the estimated ground",
           "choice: off is literal; on copes with undergrowth"},
          s.height_band);
  v.field({"band_low_m", "m", "lower edge of that band above ground", "choice"}, s.band_low_m,
          {-5.0, 50.0});
  v.field({"band_high_m", "m", "upper edge of that band above ground",
           "choice: holds the 2 m test and stays below most crowns"},
          s.band_high_m, {0.0, 100.0});
}

StemSettings map_stem_settings() {
  StemSettings settings;
  settings.cluster_threshold = 200;
  settings.points_per_sweep = 0.0;  // most sweeps of a run never see a given stem
  settings.voxel_m = 0.025;
  return settings;
}

}  // namespace honka
