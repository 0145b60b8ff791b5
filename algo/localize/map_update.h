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
  double false_match_rate = 0.03;
  double decision_ratio = 100.0;
  std::int64_t least_sightings = 3;
};
void describe(SettingsVisitor& v, MapUpdateSettings& s);

/// A stem of the map, or one that may join it.
struct MapLandmark {
  static constexpr std::size_t kRangeBins = 5;
  Eigen::Vector2d position_in_map_m = Eigen::Vector2d::Zero();
  bool in_map = false;                              ///< of the map that was given
  std::array<std::int64_t, kRangeBins> expected{};  ///< views that had it in range and view
  std::array<std::int64_t, kRangeBins> seen{};      ///< of these, those that listed it

  [[nodiscard]] std::int64_t sightings() const;
};

/// What an update decided.
struct MapUpdate {
  std::vector<Eigen::Vector2d> stems_in_map_m;  ///< kept ones in their order, then new ones
  std::vector<std::size_t> retired;             ///< indices into the map that was given
  std::size_t added = 0;
  /// Share of views in a range bin that list a stem which stands there, occlusion included.
  std::array<double, MapLandmark::kRangeBins> detection_rate{};
};

/// Keeps a stem map up to date while the stand is thinned: counts for each stem how often it was
/// in view and how often seen, and weighs "stands" against "gone". Stems that are seen and unknown
/// are counted the same way, and join.
class MapUpdater {
 public:
  /// Map of N stems, metres. Throws UserError at a coordinate that is not finite.
  MapUpdater(const std::vector<Eigen::Vector2d>& stems_in_map_m, const MapUpdateSettings& settings);

  /// An accepted localization and its stems. A view nearer than `view_spacing_m` to the last one
  /// that was counted is left out: its occlusions are the same. Returns whether it was counted.
  bool add_view(const Pose2& T_map_local, const std::vector<Eigen::Vector2d>& stems_in_local_m);

  [[nodiscard]] MapUpdate update() const;
  [[nodiscard]] const std::vector<MapLandmark>& landmarks() const { return landmarks_; }

 private:
  struct InView {
    std::size_t landmark = 0, bin = 0;
  };
  [[nodiscard]] std::vector<InView> landmarks_in_view(const Pose2& T_map_local) const;
  [[nodiscard]] std::array<double, MapLandmark::kRangeBins> detection_rates() const;

  MapUpdateSettings settings_;
  std::vector<MapLandmark> landmarks_;
  std::optional<Eigen::Vector2d> counted_from_m_;  ///< of the last view that counted
};

}  // namespace honka
