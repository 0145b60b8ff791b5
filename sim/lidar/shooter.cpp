#include "sim/lidar/shooter.h"

#include <algorithm>
#include <cmath>

#include "sim/lidar/embree_scene.h"

namespace honka::sim {

Shooter::Shooter(const LidarSimulator& lidar, const Trajectory& trajectory,
                 std::int64_t sweep_index, std::span<const Cone> occluders_in_lidar)
    : lidar_(lidar),
      scene_(*lidar.scene_),
      poses_(trajectory, static_cast<double>(sweep_index) * lidar.model_.sweep_period_s(),
             lidar.model_.sweep_period_s() + lidar.model_.firing_period_s),
      occluders_(occluders_in_lidar),
      half_view_rad_(deg_to_rad(0.5 * lidar.settings_.field_of_view_deg)) {
  Sweep& sweep = result_.sweep;
  sweep.index = sweep_index;
  sweep.start_time_s = static_cast<double>(sweep_index) * lidar.model_.sweep_period_s();
  sweep.start_azimuth_rad = -kPi;
  const double shots = lidar.model_.sweep_period_s() / lidar.model_.firing_period_s *
                       static_cast<double>(lidar.beams_.size()) *
                       (lidar.settings_.field_of_view_deg / 360.0) *
                       (lidar.mode_ == ReturnMode::kDual ? 2.0 : 1.0);
  sweep.returns.reserve(static_cast<std::size_t>(shots) + 64);
  result_.truth.reserve(static_cast<std::size_t>(shots) + 64);
}

void Shooter::fire(std::uint32_t firing, double offset_s) {
  const double azimuth = -kPi + 2.0 * kPi * lidar_.model_.rotation_rate_hz * offset_s;
  const auto seen = [&](const Beam& beam) {
    return std::fabs(azimuth + beam.turn_rad) <= half_view_rad_ || half_view_rad_ >= kPi;
  };
  if (!seen(lidar_.beams_.front()) && !seen(lidar_.beams_.back())) return;
  head_cos_ = std::cos(azimuth);
  head_sin_ = std::sin(azimuth);
  occluders_.aim(azimuth);
  for (std::uint32_t laser = 0; laser < lidar_.beams_.size(); ++laser) {
    const Beam& beam = lidar_.beams_[laser];
    if (seen(beam)) shoot(beam, firing, laser, offset_s + beam.offset_s);
  }
}

void Shooter::shoot(const Beam& beam, std::uint32_t firing, std::uint32_t laser, double offset_s) {
  shot_cos_ = head_cos_ * beam.cos_turn - head_sin_ * beam.sin_turn;
  shot_sin_ = head_sin_ * beam.cos_turn + head_cos_ * beam.sin_turn;
  const int count = trace(beam, offset_s);
  const bool dual = lidar_.mode_ == ReturnMode::kDual;
  if (count == 0) {
    report(nullptr, laser, offset_s, 0, 0);
    if (dual) report(nullptr, laser, offset_s, 0, 1);
    return;
  }
  const ShotNoise noise =
      shot_noise(lidar_.noise_key_, static_cast<std::uint64_t>(result_.sweep.index), firing, laser);
  const Reported chosen = reported(echoes_, count, lidar_.mode_);
  const Echo& first = echoes_[static_cast<std::size_t>(chosen.first)];
  report(detected(first, noise.drop_out) ? &first : nullptr, laser, offset_s, noise.range[0], 0);
  if (!dual) return;
  // The only echo is measured once and reported twice.
  const std::uint32_t bits = noise.range[chosen.second == chosen.first ? 0 : 1];
  const Echo& second = echoes_[static_cast<std::size_t>(chosen.second)];
  report(detected(second, noise.drop_out) ? &second : nullptr, laser, offset_s, bits, 1);
}

int Shooter::trace(const Beam& beam, double offset_s) {
  std::array<SubHit, kMostSubRays> hits;
  std::size_t count = 0;
  for (const SubRay& sub : lidar_.footprint_) {
    const Hit hit = cast(sub_ray(beam, sub), offset_s);
    if (hit.range_m == kNoHit || hit.range_m < lidar_.settings_.min_range_m) continue;
    hits[count++] = received(hit, sub.weight);
  }
  return form_echoes({hits.data(), count}, lidar_.settings_.pulse_resolution_m, echoes_);
}

Hit Shooter::cast(const Ray& in_lidar, double offset_s) const {
  double far = lidar_.settings_.max_range_m;
  Hit machine;
  if (occluders_.in_the_way()) {
    machine = occluders_.cast(in_lidar, far);
    far = std::min(far, machine.range_m);
  }
  const Hit hit = scene_.cast(poses_.to_world(in_lidar, offset_s), far);
  return hit.range_m < far ? hit : machine;
}

Ray Shooter::sub_ray(const Beam& beam, const SubRay& sub) const {
  const double c = shot_cos_, s = shot_sin_;
  Ray ray = {0.0,
             0.0,
             beam.origin_z_m,
             beam.cos_elevation * c,
             -beam.cos_elevation * s,
             beam.sin_elevation};
  if (sub.horizontal_rad == 0.0 && sub.vertical_rad == 0.0) return ray;
  const double h = sub.horizontal_rad, v = sub.vertical_rad;
  const double keep = 1.0 - 0.5 * (h * h + v * v);  // unit length to the fourth order
  ray.dx = keep * ray.dx - h * s - v * beam.sin_elevation * c;
  ray.dy = keep * ray.dy - h * c + v * beam.sin_elevation * s;
  ray.dz = keep * ray.dz + v * beam.cos_elevation;
  return ray;
}

SubHit Shooter::received(const Hit& hit, double weight) const {
  const double percent = lidar_.reflectivity_percent_[static_cast<std::size_t>(hit.label.part)];
  return {hit.range_m, weight * percent * hit.incidence_cosine, hit.label};
}

bool Shooter::detected(const Echo& echo, std::uint32_t bits) const {
  const double u = uniform_of(bits);
  if (u < lidar_.settings_.drop_out) return false;
  const double half = lidar_.settings_.half_detection_range_m;
  if (half <= 0.0) return true;
  // Energy over that of a 10 % target at the range where half the shots come back: 1 − 2^(−x²).
  constexpr double kTarget_percent = 10.0;
  const double x = echo.energy * half * half / kTarget_percent;
  constexpr double kCertain = 6.0;  // 2^−36 is below one step of the 32 random bits
  if (x >= kCertain) return true;
  const double kept =
      lidar_.settings_.drop_out + (1.0 - lidar_.settings_.drop_out) * std::exp2(-x * x);
  return u >= kept;
}

void Shooter::report(const Echo* echo, std::uint32_t laser, double offset_s,
                     std::uint32_t noise_bits, std::uint8_t number) {
  Return r;
  r.time_offset_ns = static_cast<std::uint32_t>(offset_s * 1e9 + 0.5);
  r.laser = static_cast<std::uint8_t>(laser);
  r.echo = number;
  ReturnTruth truth;
  if (echo != nullptr) {
    const double sigma = lidar_.settings_.range_noise_m;
    const double measured = echo->range_m + lidar_.biases_m_[laser] +
                            (sigma > 0.0 ? sigma * normal_of(noise_bits) : 0.0);
    const double ticks = measured / lidar_.model_.range_resolution_m + 0.5;
    if (ticks >= 1.0) {
      r.range_ticks = static_cast<std::uint16_t>(std::min(ticks, 65535.0));
      r.reflectivity = static_cast<std::uint8_t>(std::min(echo->brightness + 0.5, 100.0));
      truth = {echo->label, static_cast<float>(echo->exact_range_m)};
    }
  }
  result_.sweep.returns.push_back(r);
  result_.truth.push_back(truth);
}

}  // namespace honka::sim
