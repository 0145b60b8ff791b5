#pragma once

#include <cstdint>
#include <vector>

#include "sim/harvester/knot_trajectory.h"
#include "sim/harvester/smooth_path.h"
#include "sim/harvester/vehicle_settings.h"
#include "sim/harvester/work_plan.h"
#include "sim/world/heightfield.h"

namespace honka::sim {

/// Time between two knots of the truth.
inline constexpr double kTruthKnot_s = 0.01;

/// Poses of the lidar every kTruthKnot_s of the plan: heading from path and swing, roll and pitch
/// from the ground under the front body and its suspension, then the lever arm and the mounting.
[[nodiscard]] std::vector<PoseKnot> truth_knots(const SmoothPath& path, const WorkPlan& plan,
                                                const Heightfield& terrain,
                                                const VehicleSettings& settings,
                                                std::uint64_t seed);

/// Driving direction at a place of the path: from the joint to the front axle ahead on it. Radians.
[[nodiscard]] double driving_direction_rad(const SmoothPath& path, double along_m,
                                           double front_length_m);

}  // namespace honka::sim
