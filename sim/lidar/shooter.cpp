#include "sim/lidar/shooter.h"

#include <algorithm>
#include <cmath>

namespace honka::sim {

Shooter::Shooter(const LidarSimulator& lidar, const Trajectory& trajectory,
                 std::int64_t sweep_index, std::span<const Cone> occluders_in_lidar)
    : lidar_(lidar),
      scene_(*lidar.scene_),
      poses_(trajectory, static_cast<double>(sweep_index) * lidar.model_.sweep_period_s(),
             lidar.model_.sweep_period_s() + lidar.model_.firing_period_s),
      occluders_(occluders_in_lidar),
      ticks_per_m_(1.0 / lidar.model_.range_resolution_m),
      half_view_rad_(deg_to_rad(0.5 * lidar.settings_.field_of_view_deg)),
      queries_(lidar.beams_.size() * lidar.footprint_.size()) {
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

bool Shooter::in_view(double azimuth_rad) const {
  return std::fabs(azimuth_rad) <= half_view_rad_ || half_view_rad_ >= kPi;
}

void Shooter::fire(std::uint32_t firing, double offset_s) {
  const std::vector<Beam>& beams = lidar_.beams_;
  const double azimuth = -kPi + 2.0 * kPi * lidar_.model_.rotation_rate_hz * offset_s;
  // Lasers in view are consecutive: the head turns one way.
  std::uint32_t first = 0, end = static_cast<std::uint32_t>(beams.size());
  while (first < end && !in_view(azimuth + beams[first].turn_rad)) ++first;
  while (end > first && !in_view(azimuth + beams[end - 1].turn_rad)) --end;
  if (first == end) return;
  head_cos_ = std::cos(azimuth);
  head_sin_ = std::sin(azimuth);
  occluders_.aim(azimuth);
  // The rays of a firing are aimed, cast and received together: short loops, one after the other.
  aimed_ = 0;
  machine_.clear();
  for (std::uint32_t laser = first; laser < end; ++laser) {
    aim(beams[laser], offset_s + beams[laser].offset_s);
  }
  scene_.cast({queries_.data(), aimed_});
  std::size_t query = 0;
  for (std::uint32_t laser = first; laser < end; ++laser, query += lidar_.footprint_.size()) {
    finish(firing, laser, offset_s + beams[laser].offset_s, receive(query));
  }
}

void Shooter::aim(const Beam& beam, double offset_s) {
  const SweepPoses::Matrix34 T_world_lidar = poses_.at(offset_s);
  const double c = head_cos_ * beam.cos_turn - head_sin_ * beam.sin_turn;
  const double s = head_sin_ * beam.cos_turn + head_cos_ * beam.sin_turn;
  const double flat = beam.cos_elevation, steep = beam.sin_elevation;
  for (const SubRay& sub : lidar_.footprint_) {
    const double h = sub.horizontal_rad, v = sub.vertical_rad;
    const double keep = 1.0 - 0.5 * (h * h + v * v);  // unit length to the fourth order
    const double out = keep * flat - v * steep;
    const Ray ray = {
        0.0, 0.0, beam.origin_z_m, out * c - h * s, -out * s - h * c, keep * steep + v * flat};
    double far = lidar_.settings_.max_range_m;
    if (occluders_.in_the_way()) {
      machine_.push_back(occluders_.cast(ray, far));
      far = std::min(far, machine_.back().range_m);
    }
    EmbreeScene::aim(queries_[aimed_++], to_world(T_world_lidar, ray), far);
  }
}

Hit Shooter::hit_of(std::size_t query) const {
  const Hit hit = scene_.hit_of(queries_[query]);
  return hit.range_m == kNoHit && !machine_.empty() ? machine_[query] : hit;
}

int Shooter::receive(std::size_t first) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < lidar_.footprint_.size(); ++i) {
    const Hit hit = hit_of(first + i);
    if (hit.range_m == kNoHit || hit.range_m < lidar_.settings_.min_range_m) continue;
    const double percent = lidar_.reflectivity_percent_[static_cast<std::size_t>(hit.label.part)];
    hits_[count++] = {hit.range_m, lidar_.footprint_[i].weight * percent * hit.incidence_cosine,
                      hit.label};
  }
  if (count == 1) {
    echoes_[0] = only_echo(hits_[0]);
    return 1;
  }
  return form_echoes({hits_.data(), count}, lidar_.settings_.pulse_resolution_m, echoes_);
}

void Shooter::finish(std::uint32_t firing, std::uint32_t laser, double offset_s, int echoes) {
  const bool dual = lidar_.mode_ == ReturnMode::kDual;
  if (echoes == 0) {
    report(nullptr, laser, offset_s, 0, 0);
    if (dual) report(nullptr, laser, offset_s, 0, 1);
    return;
  }
  const ShotNoise noise =
      shot_noise(lidar_.noise_key_, static_cast<std::uint64_t>(result_.sweep.index), firing, laser);
  const Reported chosen = reported(echoes_, echoes, lidar_.mode_);
  const Echo& first = echoes_[static_cast<std::size_t>(chosen.first)];
  report(detected(first, noise.drop_out) ? &first : nullptr, laser, offset_s, noise.range[0], 0);
  if (!dual) return;
  // The only echo is measured once and reported twice.
  const std::uint32_t bits = noise.range[chosen.second == chosen.first ? 0 : 1];
  const Echo& second = echoes_[static_cast<std::size_t>(chosen.second)];
  report(detected(second, noise.drop_out) ? &second : nullptr, laser, offset_s, bits, 1);
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
  r.time_offset_ns = static_cast<std::uint32_t>(static_cast<std::int64_t>(offset_s * 1e9 + 0.5));
  r.laser = static_cast<std::uint8_t>(laser);
  r.echo = number;
  ReturnTruth truth;
  if (echo != nullptr) {
    const double sigma = lidar_.settings_.range_noise_m;
    const double measured = echo->range_m + lidar_.biases_m_[laser] +
                            (sigma > 0.0 ? sigma * normal_of(noise_bits) : 0.0);
    const double ticks = measured * ticks_per_m_ + 0.5;
    if (ticks >= 1.0) {
      r.range_ticks = static_cast<std::uint16_t>(static_cast<int>(std::min(ticks, 65535.0)));
      r.reflectivity =
          static_cast<std::uint8_t>(static_cast<int>(std::min(echo->brightness + 0.5, 100.0)));
      truth = {echo->label, static_cast<float>(echo->exact_range_m)};
    }
  }
  result_.sweep.returns.push_back(r);
  result_.truth.push_back(truth);
}

}  // namespace honka::sim
