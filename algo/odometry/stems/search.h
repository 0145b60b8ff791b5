#pragma once

#include <optional>
#include <span>

#include "algo/odometry/stems/landmarks.h"
#include "algo/odometry/stems/settings.h"

namespace honka {

/// Where, around a predicted pose, the sightings lie on landmarks best: votes of all pairs of a
/// sighting and a landmark near for a shift in the plane, for each of some yaw angles. Nothing when
/// fewer than `min_stems` agree.
[[nodiscard]] std::optional<Pose3> search_place(std::span<const PlacedSighting> sightings,
                                                const StemLandmarkMap& stems,
                                                const Pose3& T_odom_predicted,
                                                const StemRegistrationSettings& settings);

}  // namespace honka
