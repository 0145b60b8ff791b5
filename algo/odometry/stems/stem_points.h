#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/odometry/stems/settings.h"
#include "algo/types/lidar_model.h"
#include "algo/types/sweep.h"

namespace honka {

/// One ring's cut through something stem-like, in the lidar frame at its own time.
struct StemArc {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< on the stem's axis
  Eigen::Vector2d ray = Eigen::Vector2d::UnitX();      ///< horizontal direction away from the lidar
  double range_m = 0.0;                                ///< horizontal, to the surface
  double width_m = 0.0;                                ///< as the returns span it
  double sigma_m = 0.0;   ///< s.d. of the centre in the plane, from the model of the lidar
  double share = 0.0;     ///< of the revolution that has passed, 0 … 1
  std::int32_t ring = 0;  ///< by rising elevation
  std::int32_t returns = 0;
};

/// A stem as one sweep shows it: arcs of several rings above each other, on one line.
struct StemSighting {
  std::uint32_t first_arc = 0, arcs = 0;               ///< its arcs, from the top
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< on the axis, amid the arcs
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();     ///< of the axis: x and y per metre of z
  double centre_sigma_m = 0.0;                         ///< in the plane, of each component
  double slope_sigma = 0.0;                            ///< of each component
  double share = 0.0;                                  ///< of the revolution that has passed
  double radius_m = 0.0;
  double span_m = 0.0;  ///< height between the lowest and the highest arc
};

struct StemPoints {
  std::vector<StemArc> arcs;
  std::vector<StemSighting> sightings;

  [[nodiscard]] std::span<const StemArc> arcs_of(const StemSighting& s) const {
    return std::span(arcs).subspan(s.first_arc, s.arcs);
  }
};

/// Finds the stems of single sweeps in one pass over the returns.
///
/// On each ring, returns without a jump in range that have something farther on both sides are an
/// arc; arcs of neighbouring rings above each other are a chain; a chain on one line that stands is
/// a sighting. The centre of an arc lies kMeanDepth · r behind its mean range (algo/stems), r from
/// the mean width of the sighting's arcs. Holds its buffers, so that a sweep allocates nothing.
class StemPointFinder {
 public:
  StemPointFinder(const LidarModel& model, const StemPointSettings& settings);

  /// The sightings of a sweep in the lidar frame; each arc at its own time. `up`: about where the
  /// zenith is in the lidar frame. The answer holds until the next call.
  const StemPoints& find(const Sweep& sweep, const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

 private:
  struct Beam {
    double horizontal, vertical, offset_m;
    std::int32_t ring;
  };
  /// Returns of one laser without a jump in range.
  struct Segment {
    std::int32_t returns = 0;
    std::uint32_t first_ns = 0, last_ns = 0;
    std::uint64_t ticks_sum = 0;
    std::int32_t first_ticks = 0, last_ticks = 0;
    std::int32_t before_ticks = 0;  ///< of the return before it; 0: unknown
  };
  /// How an arc hangs together with others; indices into arcs_, -1 for none.
  struct Link {
    std::int32_t below, next_in_bucket;
    bool topped;  ///< another arc stands on it
  };

  void segment(const Sweep& sweep);
  void close(const Segment& s, const Beam& beam, std::int32_t after_ticks,
             double start_azimuth_rad);
  void chain_arcs();
  [[nodiscard]] std::int32_t chain_below(const StemArc& arc) const;
  [[nodiscard]] static std::size_t bucket_of(const StemArc& arc);
  void keep_stems(const Eigen::Vector3d& up);
  /// Reorders `arcs` and returns how many of them stay; 0: no stem.
  [[nodiscard]] std::size_t fit_axis(std::span<StemArc> arcs, StemSighting& s) const;

  LidarModel model_;
  StemPointSettings settings_;
  std::vector<Beam> beams_;
  double azimuth_per_ns_ = 0.0, step_rad_ = 0.0;

  std::vector<Segment> segments_;                ///< one for each laser
  std::vector<std::vector<StemArc>> ring_arcs_;  ///< by rising elevation; in each by azimuth
  std::vector<StemArc> arcs_;                    ///< those of all rings
  std::vector<Link> links_;                      ///< one for each of them
  std::vector<std::int32_t> bucket_heads_;
  StemPoints points_;
};

}  // namespace honka
