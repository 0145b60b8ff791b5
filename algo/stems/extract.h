#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algo/types/local_cloud.h"
#include "algo/types/settings.h"
#include "algo/types/stem.h"

namespace honka {

/// Algorithm 1 of Li2020 and its variants. The defaults are for a local cloud of a few key frames;
/// `map_stem_settings()` is the same for the cloud of a whole run.
struct StemSettings {
  std::string form = "journal";
  std::string search = "voxel_hash";
  std::string centre = "mean";
  double height_offset_m = 2.0;
  double d_threshold_m = 0.3;
  double planar_radius_m = 0.05;
  double cluster_link_m = 0.2;
  std::int64_t cluster_threshold = 5;
  double points_per_sweep = 1.5;
  double max_range_m = 40.0;
  double voxel_m = 0.0;
  bool height_band = false;
  double band_low_m = 0.4;
  double band_high_m = 7.0;
};

void describe(SettingsVisitor& v, StemSettings& s);

/// The defaults for the map of a run: cluster threshold 200, voxels of 2.5 cm.
[[nodiscard]] StemSettings map_stem_settings();

/// A stem found in a cloud, in the cloud's frame.
struct ObservedStem {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  std::optional<double> dbh_m;  ///< where a circle could be fitted
  std::int32_t points = 0;      ///< of its cluster
  double z_m = 0.0;             ///< ground beside it with the height band, else its lowest point
};

/// How far a point came in Algorithm 1 (Li2020, Figure 5).
enum class PointStage : std::uint8_t {
  kDropped,         ///< nothing 2 m above, nothing within 5 cm, too far, or outside the band
  kTrunkCandidate,  ///< passed both tests, in a cluster below the threshold
  kClustered,       ///< in a cluster that became a stem
};

struct StemExtraction {
  std::vector<ObservedStem> stems;  ///< by rising x, then y
  std::vector<PointStage> stages;   ///< one for each point of the cloud
};

/// Stems of a levelled cloud (z up), by Algorithm 1 of Li2020 in the form that `settings` name.
///
/// journal: keep points with a neighbour within `d_threshold_m` of the spot `height_offset_m`
/// above; project to the plane; keep those with another within `planar_radius_m`; Euclidean
/// clusters; drop those of fewer than `cluster_threshold` points, or of fewer than
/// `points_per_sweep` for each sweep of the cloud; one stem a cluster. preprint:
/// no projection and no planar test, clusters in 3D, mean of the horizontal projections.
/// All distances are strict (d < threshold), as printed. Both searches give the same stems.
/// Throws UserError on a point that is not finite or an unknown word in the settings. An empty
/// cloud has no stems.
[[nodiscard]] StemExtraction extract_stems(const LocalCloud& cloud, const StemSettings& settings);

/// The landmarks alone: position, z, DBH and points as observations.
[[nodiscard]] StemMap stem_map_of(const std::vector<ObservedStem>& stems);

}  // namespace honka
