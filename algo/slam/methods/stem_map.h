#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/sparse_frame.h"
#include "algo/types/settings.h"

namespace honka {

/// How observations of all frames become stems.
struct StemMapSettings {
  double gate_m = 0.5;                ///< an observation belongs to a stem nearer than this
  std::int64_t min_observations = 5;  ///< fewer are no stem
};
void describe(SettingsVisitor& v, StemMapSettings& s);

/// A stem of the map.
struct MapStem {
  Eigen::Vector3d position_in_first_m = Eigen::Vector3d::Zero();
  int observations = 0;  ///< frames that saw it
  double rmse_m = 0.0;   ///< planar, of its observations about their mean
};

/// A point of a frame that belongs to a stem.
struct StemObservation {
  std::uint32_t frame = 0, point = 0;  ///< positions in the list of frames and in its points
  std::uint32_t stem = 0;              ///< position in the list of stems
};

/// Stems, and which points of which frames they are made of.
struct StemMap3 {
  std::vector<MapStem> stems;
  std::vector<StemObservation> observations;  ///< by frame, then by point
};

/// Sets `rmse_m` of each stem from its observations and its position.
void measure_scatter(StemMap3& map, std::span<const SparseFrame> frames,
                     const FramePoses& T_first_frame);

/// Gathers the points of all frames into stems: clusters of the plane, each frame giving at most
/// one point, its nearest, to a stem. Points in no stem are left out. Deterministic.
[[nodiscard]] StemMap3 build_stem_map(std::span<const SparseFrame> frames,
                                      const FramePoses& T_first_frame,
                                      const StemMapSettings& settings);

}  // namespace honka
