#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algo/types/pose.h"
#include "algo/types/settings.h"

namespace honka {

/// How accepted localizations change a stem map.
struct MapUpdateSettings {
  double range_m = 25.0;
  double field_of_view_deg = 210.0;
  double pairing_gate_m = 0.6;
  double view_spacing_m = 2.0;
  double least_paired_share = 0.5;
  double false_match_rate = 0.03;
  double decision_ratio = 100.0;
  std::int64_t least_sightings = 3;
};
void describe(SettingsVisitor& v, MapUpdateSettings& s);

/// A counted view that had a landmark in it.
struct LandmarkView {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();  ///< the sensor, in the map
  std::uint8_t bin = 0;                              ///< of the range, in fifths
  bool seen = false;                                 ///< whether the list had it
};

/// A stem of the map, or one that may join it.
struct MapLandmark {
  static constexpr std::size_t kRangeBins = 5;
  /// Of a map stem as it was given, of another the mean of where it was seen.
  Eigen::Vector2d position_in_map_m = Eigen::Vector2d::Zero();
  bool in_map = false;              ///< of the map that was given
  std::int64_t sightings = 0;       ///< lists that had it, the one that founded it among them
  std::vector<LandmarkView> views;  ///< oldest first; of each place the newest alone
};

/// What an update decided.
struct MapUpdate {
  std::vector<Eigen::Vector2d> stems_in_map_m;  ///< kept ones in their order, then new ones
  std::vector<std::size_t> retired;             ///< indices into the map that was given
  std::size_t added = 0;
  /// Share of views in a range bin that list a stem which stands there, occlusion included.
  std::array<double, MapLandmark::kRangeBins> detection_rate{};
};

/// Keeps a stem map up to date while the stand is thinned: remembers of each stem from where it was
/// in view and whether it was seen, and weighs "stands" against "gone since some view". Stems that
/// are seen and unknown are weighed the same way, and join. Nothing is final: a stem that was
/// retired and is seen again comes back at the next update.
class MapUpdater {
 public:
  /// Map of N stems, metres. Throws UserError at a coordinate that is not finite.
  MapUpdater(const std::vector<Eigen::Vector2d>& stems_in_map_m, const MapUpdateSettings& settings);

  /// An accepted localization and its stems; the pose is fitted anew to the stems of the map that
  /// it lays them on. Left out, and answered with false: a view nearer than `view_spacing_m` to the
  /// last one that was counted, whose occlusions are the same; one of which less than
  /// `least_paired_share` lies on stems, whose pose is wrong or whose place is not mapped. A view
  /// from a place that was counted long ago takes the older one's place.
  bool add_view(const Pose2& T_map_local, const std::vector<Eigen::Vector2d>& stems_in_local_m);

  [[nodiscard]] MapUpdate update() const;
  [[nodiscard]] const std::vector<MapLandmark>& landmarks() const { return landmarks_; }

  /// A listed stem and the landmark that it is.
  struct Pair {
    double distance_m = 0.0;
    std::size_t listed = 0, landmark = 0;
  };

 private:
  [[nodiscard]] std::vector<std::size_t> landmarks_around(const Eigen::Vector2d& place_m,
                                                          double reach_m) const;
  void remember_view(const Pose2& T_map_local, const std::vector<std::size_t>& near,
                     const std::vector<Pair>& pairs);

  MapUpdateSettings settings_;
  std::vector<MapLandmark> landmarks_;
  std::optional<Eigen::Vector2d> counted_from_m_;  ///< of the last view that counted
};

}  // namespace honka
