#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algo/delaunay/delaunay.h"
#include "algo/localize/matcher.h"
#include "algo/odometry/aggregate.h"
#include "algo/stems/extract.h"
#include "eval/config/scenario.h"

namespace honka::eval {

/// A trunk map as a machine would carry it: made from scans and odometry, no truth in it.
struct TrunkMap {
  std::string source;               ///< prior_run | same_run
  bool repaired = false;            ///< height band and unbiased centres
  std::vector<ObservedStem> stems;  ///< in the map frame: the odometry's, laid onto the world
  DelaunayGraph graph;
  double extract_s = 0.0;

  [[nodiscard]] std::vector<Eigen::Vector2d> positions_m() const;
};

/// Algorithm 1 and the Delaunay graph over the cloud of a whole run. `T_world_odom` then moves the
/// stems rigidly, so that the map frame is the world's but for what the odometry bent: matching
/// does not feel it, and answers can be compared with truth.
[[nodiscard]] TrunkMap make_trunk_map(std::string source, const LocalCloud& cloud_in_odom,
                                      const StemSettings& settings, const Pose2& T_world_odom);

/// Settings of the repaired chain: height band 0.4–7 m, centres without the one-sided bias.
[[nodiscard]] StemSettings repaired(StemSettings settings, const std::string& centre);

/// One way of localizing: which map, which tolerance, which form of Algorithm 1.
struct Variant {
  std::string name;  ///< "default", "same_run", "tolerance_3.5", "repaired", "consensus"
  std::string method;
  const TrunkMap* map = nullptr;
  double tolerance_m2 = 0.0;
  StemSettings stems;                ///< for the local cloud
  std::unique_ptr<Matcher> matcher;  ///< null where the map holds nothing to match
};

/// The default first, then what `scenario.variants` asks for.
[[nodiscard]] std::vector<Variant> make_variants(const Scenario& scenario,
                                                 const std::vector<TrunkMap>& maps);

}  // namespace honka::eval
