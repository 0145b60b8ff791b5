#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/slam/slam.h"

namespace honka {

/// What one vehicle brings: its frames, and its own chain where it has one.
struct VehicleDrive {
  std::vector<SparseFrame> frames;
  std::optional<FramePoses> T_first_frame_chain;
};

/// How the maps of several vehicles are joined.
struct FleetSettings {
  std::int64_t lookout_step = 32;  ///< frames between those that look for the other vehicle
  std::int64_t min_joins = 2;      ///< matches that must agree on where one map lies in the other
  double agreement_m = 1.0;
  double agreement_deg = 3.0;
};
void describe(SettingsVisitor& v, FleetSettings& s);

/// One vehicle's part of the map. Where it could not be joined its poses are in its own first
/// frame, and nothing else is known of them.
struct VehicleMap {
  bool joined = false;
  FramePoses T_map_frame;
  std::vector<FrameStatus> frames;
  std::size_t joins = 0;  ///< matches with other vehicles that were used
};

/// The map of several vehicles, in the first frame of the first vehicle that has any.
struct FleetResult {
  std::vector<VehicleMap> vehicles;  ///< as given
  std::vector<MapStem> stems;        ///< of the joined ones
};

/// Maps each vehicle alone by the method of `settings`, finds by landmark matching where their maps
/// overlap, and adjusts what is joined together: pose graph, and poses with stems where the method
/// is landmark_ba. No vehicle needs to know where another began. Errors as run_slam; a vehicle
/// without frames is not joined. Source: choice, beyond Nevalainen2021.
[[nodiscard]] FleetResult run_fleet(std::span<const VehicleDrive> vehicles,
                                    const SlamSettings& settings, const FleetSettings& fleet);

}  // namespace honka
