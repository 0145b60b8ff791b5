#include "algo/odometry/stems/landmarks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kLookAgain_m = 2.0;

Eigen::Vector2d slope_of(const Eigen::Vector3d& axis) { return axis.head<2>() / axis.z(); }

}  // namespace

void StemLandmarkMap::clear() {
  landmarks_.clear();
  near_.clear();
  looked_from_m_.setConstant(1e9);
}

void StemLandmarkMap::look_around(const Eigen::Vector2d& place_m) {
  if ((place_m - looked_from_m_).squaredNorm() < kLookAgain_m * kLookAgain_m) return;
  looked_from_m_ = place_m;
  near_.clear();
  const double radius2 = settings_.radius_m * settings_.radius_m;
  for (std::uint32_t i = 0; i < landmarks_.size(); ++i) {
    if ((landmarks_[i].place_m - place_m).squaredNorm() < radius2) near_.push_back(i);
  }
}

void StemLandmarkMap::associate(std::span<const PlacedSighting> sightings, const Pose3& T_odom_mid,
                                double gate_m, std::vector<StemPair>& pairs) {
  pairs.clear();
  taken_.assign(near_.size(), std::numeric_limits<double>::infinity());
  pair_.assign(near_.size(), -1);
  for (std::uint32_t s = 0; s < sightings.size(); ++s) {
    const Eigen::Vector3d centre_m = T_odom_mid * sightings[s].centre_m;
    double best = gate_m * gate_m;
    std::size_t chosen = near_.size();
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const StemLandmark& landmark = landmarks_[near_[k]];
      const double d2 = (landmark.at(centre_m.z()) - centre_m.head<2>()).squaredNorm();
      if (d2 < best) {
        best = d2;
        chosen = k;
      }
    }
    if (chosen == near_.size() || best >= taken_[chosen]) continue;
    taken_[chosen] = best;
    if (pair_[chosen] < 0) {
      pair_[chosen] = static_cast<std::int32_t>(pairs.size());
      pairs.push_back({s, near_[chosen]});
    } else {
      pairs[static_cast<std::size_t>(pair_[chosen])].sighting = s;
    }
  }
}

void StemLandmarkMap::refine(StemLandmark& landmark, const PlacedSighting& sighting,
                             const Pose3& T_odom_mid) {
  const Eigen::Vector3d centre_m = T_odom_mid * sighting.centre_m;
  const double h = centre_m.z() - landmark.z_m;
  const double floor_m = settings_.sigma_m, floor_slope = deg_to_rad(settings_.slope_sigma_deg);
  const double w = 1.0 / (sighting.sigma_m * sighting.sigma_m + floor_m * floor_m);
  const double w_slope =
      1.0 / (sighting.slope_sigma * sighting.slope_sigma + floor_slope * floor_slope);
  const Eigen::Vector2d at(1.0, h);
  landmark.information += w * at * at.transpose();
  landmark.information(1, 1) += w_slope;
  landmark.right += w * at * centre_m.head<2>().transpose();
  landmark.right.row(1) += w_slope * slope_of(T_odom_mid.linear() * sighting.axis).transpose();
  landmark.covariance = landmark.information.inverse();
  const Eigen::Matrix2d line = landmark.covariance * landmark.right;
  landmark.place_m = line.row(0).transpose();
  landmark.slope = line.row(1).transpose();
  landmark.last_key_frame = key_frame_;
  ++landmark.seen;
}

void StemLandmarkMap::learn(std::span<const PlacedSighting> sightings, const Pose3& T_odom_mid,
                            std::span<const StemPair> pairs) {
  ++key_frame_;
  std::vector<bool> known(sightings.size(), false);
  for (const StemPair& pair : pairs) {
    refine(landmarks_[pair.landmark], sightings[pair.sighting], T_odom_mid);
    known[pair.sighting] = true;
  }
  const double lean = std::tan(deg_to_rad(std::max(settings_.lean_deg, 0.01)));
  for (std::size_t s = 0; s < sightings.size(); ++s) {
    if (known[s]) continue;
    const Eigen::Vector3d centre_m = T_odom_mid * sightings[s].centre_m;
    const bool crowded = std::any_of(near_.begin(), near_.end(), [&](std::uint32_t i) {
      return (landmarks_[i].at(centre_m.z()) - centre_m.head<2>()).norm() < settings_.apart_m;
    });
    if (crowded) continue;
    StemLandmark fresh;
    fresh.z_m = centre_m.z();
    fresh.information(1, 1) = 1.0 / (lean * lean);  // prior: it stands
    refine(fresh, sightings[s], T_odom_mid);
    near_.push_back(static_cast<std::uint32_t>(landmarks_.size()));
    landmarks_.push_back(fresh);
  }
  forget();
}

void StemLandmarkMap::forget() {
  const std::size_t before = landmarks_.size();
  std::erase_if(landmarks_, [&](const StemLandmark& landmark) {
    return landmark.seen < settings_.confirm &&
           key_frame_ - landmark.last_key_frame > settings_.forget_key_frames;
  });
  const auto most = static_cast<std::size_t>(settings_.max_landmarks);
  if (landmarks_.size() > most) {
    std::stable_sort(landmarks_.begin(), landmarks_.end(),
                     [](const StemLandmark& a, const StemLandmark& b) {
                       return a.last_key_frame > b.last_key_frame;
                     });
    landmarks_.resize(most - most / 10);  // some room, not a sort with every key frame
  }
  if (landmarks_.size() != before) {
    const Eigen::Vector2d place_m = looked_from_m_;
    looked_from_m_.setConstant(1e9);
    look_around(place_m);
  }
}

}  // namespace honka
