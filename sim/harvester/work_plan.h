#pragma once

#include <cstdint>
#include <vector>

#include "sim/harvester/vehicle_settings.h"

namespace honka::sim {

enum class Task { kDrive, kSwing, kProcess };

/// One piece of the work: the joint goes from one place of the path to another, or the front body
/// swings from one angle to another, or both rest.
struct Phase {
  Task task = Task::kDrive;
  double start_s = 0.0, duration_s = 0.0;
  double from_m = 0.0, to_m = 0.0;      ///< along the path
  double from_rad = 0.0, to_rad = 0.0;  ///< swing, left positive
  double ramp_s = 0.0;                  ///< of a drive: time to gain speed
  std::uint64_t stem = 0;               ///< number of the processed stem
};

/// Drive–stop–swing–process–drive over `length_m`; one drive without work cycle.
class WorkPlan {
 public:
  WorkPlan(double length_m, const VehicleSettings& settings, std::uint64_t seed);

  [[nodiscard]] double duration_s() const;
  [[nodiscard]] const Phase& at(double time_s) const;
  [[nodiscard]] double travelled_m(double time_s) const;
  /// Angle of the front body against the driving direction, left positive.
  [[nodiscard]] double swing_rad(double time_s) const;
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

 private:
  void drive(double from_m, double to_m, const VehicleSettings& settings);
  void swing(double to_rad, const VehicleSettings& settings);
  void stop(const VehicleSettings& settings, std::uint64_t seed, std::uint64_t number);
  void append(Phase phase);

  std::vector<Phase> phases_;
  std::uint64_t stems_ = 0;
};

}  // namespace honka::sim
