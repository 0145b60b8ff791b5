#include "sim/harvester/work_plan.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// Distance after `t` of a start from rest to speed v within `ramp`, as a cosine: the acceleration
/// is continuous and peaks at π v / (2 ramp).
double ramp_distance(double t, double ramp, double v) {
  return 0.5 * v * (t - ramp / kPi * std::sin(kPi * t / ramp));
}

/// 0 → 1 with zero speed and acceleration at both ends; the steepest slope is 15/8.
double smooth_step(double x) {
  const double u = std::clamp(x, 0.0, 1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}
constexpr double kSteepest = 15.0 / 8.0;

}  // namespace

WorkPlan::WorkPlan(double length_m, const VehicleSettings& settings, std::uint64_t seed) {
  HONKA_CHECK(length_m > 0.0, "a path without length");
  if (!settings.work_cycle) {
    drive(0.0, length_m, settings);
    return;
  }
  const double most = std::max(settings.least_hop_m, settings.most_hop_m);
  double place = 0.0;
  for (std::uint64_t number = 0; place < length_m; ++number) {
    RandomStream stream(seed, "vehicle_hop", {number});
    double next = std::min(length_m, place + stream.uniform(settings.least_hop_m, most));
    if (length_m - next < 0.5 * settings.least_hop_m) next = length_m;
    drive(place, next, settings);
    place = next;
    stop(settings, seed, number);
  }
}

void WorkPlan::append(Phase phase) {
  if (!phases_.empty()) phase.start_s = phases_.back().start_s + phases_.back().duration_s;
  phases_.push_back(phase);
}

void WorkPlan::drive(double from_m, double to_m, const VehicleSettings& settings) {
  const double distance = to_m - from_m;
  const double a = settings.acceleration_m_s2;
  // With ramp = π v / (2 a) both ramps together take v · ramp metres.
  const double speed = std::min(settings.drive_speed_m_s, std::sqrt(2.0 * a * distance / kPi));
  Phase phase;
  phase.ramp_s = 0.5 * kPi * speed / a;
  phase.duration_s = 2.0 * phase.ramp_s + std::max(0.0, distance / speed - phase.ramp_s);
  phase.from_m = from_m;
  phase.to_m = to_m;
  append(phase);
}

void WorkPlan::swing(double to_rad, const VehicleSettings& settings) {
  Phase phase = phases_.back();
  phase.task = Task::kSwing;
  phase.from_m = phase.to_m;
  phase.from_rad = phase.to_rad;
  phase.to_rad = to_rad;
  phase.duration_s =
      kSteepest * std::fabs(to_rad - phase.from_rad) / deg_to_rad(settings.swing_rate_deg_s);
  if (phase.duration_s > 0.0) append(phase);
}

void WorkPlan::stop(const VehicleSettings& settings, std::uint64_t seed, std::uint64_t number) {
  RandomStream stream(seed, "vehicle_stop", {number});
  const double most = std::max(settings.least_swing_deg, settings.most_swing_deg);
  double side = stream.uniform() < 0.5 ? 1.0 : -1.0;
  for (std::int64_t i = 0; i < settings.stems_per_stop; ++i, side = -side) {
    swing(side * deg_to_rad(stream.uniform(settings.least_swing_deg, most)), settings);
    Phase phase = phases_.back();
    phase.task = Task::kProcess;
    phase.from_m = phase.to_m;
    phase.from_rad = phase.to_rad;
    phase.duration_s = settings.process_s;
    phase.stem = stems_++;
    append(phase);
  }
  swing(0.0, settings);
}

double WorkPlan::duration_s() const { return phases_.back().start_s + phases_.back().duration_s; }

const Phase& WorkPlan::at(double time_s) const {
  const auto after = std::upper_bound(phases_.begin(), phases_.end(), time_s,
                                      [](double t, const Phase& p) { return t < p.start_s; });
  return after == phases_.begin() ? phases_.front() : *(after - 1);
}

double WorkPlan::travelled_m(double time_s) const {
  const Phase& p = at(time_s);
  if (p.task != Task::kDrive) return p.to_m;
  const double t = std::clamp(time_s - p.start_s, 0.0, p.duration_s);
  const double cruise = p.duration_s - 2.0 * p.ramp_s;
  const double speed = (p.to_m - p.from_m) / (p.ramp_s + cruise);
  if (t < p.ramp_s) return p.from_m + ramp_distance(t, p.ramp_s, speed);
  if (t > p.ramp_s + cruise) return p.to_m - ramp_distance(p.duration_s - t, p.ramp_s, speed);
  return p.from_m + speed * (t - 0.5 * p.ramp_s);
}

double WorkPlan::swing_rad(double time_s) const {
  const Phase& p = at(time_s);
  if (p.task != Task::kSwing) return p.to_rad;
  return p.from_rad + (p.to_rad - p.from_rad) * smooth_step((time_s - p.start_s) / p.duration_s);
}

}  // namespace honka::sim
