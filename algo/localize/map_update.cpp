#include "algo/localize/map_update.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "algo/localize/consensus/fit.h"
#include "algo/localize/landmark_evidence.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using LandmarkPair = MapUpdater::Pair;

/// Whether the sensor would have a place in view even if it stood a margin farther to any side.
bool is_surely_in_view(const Eigen::Vector2d& place_in_local_m, const MapUpdateSettings& s) {
  const double margin_m = s.pairing_gate_m;
  const double range_m = place_in_local_m.norm();
  if (range_m >= s.range_m - margin_m) return false;
  if (s.field_of_view_deg >= 360.0) return true;
  const double bearing_rad = std::abs(std::atan2(place_in_local_m.y(), place_in_local_m.x()));
  const double inside_rad = 0.5 * deg_to_rad(s.field_of_view_deg) - bearing_rad;
  if (inside_rad <= 0.0) return false;
  // To the ray that ends the view, or to the sensor where that ray points away.
  const double away_m = inside_rad < 0.5 * kPi ? range_m * std::sin(inside_rad) : range_m;
  return away_m >= margin_m;
}

/// One to one, nearest first: of two stems within the gate of one landmark the other is new.
std::vector<LandmarkPair> nearest_pairs(const std::vector<Eigen::Vector2d>& listed_in_map_m,
                                        const std::vector<std::size_t>& near,
                                        const std::vector<MapLandmark>& landmarks, double gate_m) {
  std::vector<LandmarkPair> all;
  for (std::size_t i = 0; i < listed_in_map_m.size(); ++i) {
    for (const std::size_t landmark : near) {
      const double distance_m = (landmarks[landmark].position_in_map_m - listed_in_map_m[i]).norm();
      if (distance_m < gate_m) all.push_back({distance_m, i, landmark});
    }
  }
  std::sort(all.begin(), all.end(), [](const LandmarkPair& a, const LandmarkPair& b) {
    return std::tie(a.distance_m, a.listed, a.landmark) <
           std::tie(b.distance_m, b.listed, b.landmark);
  });
  std::vector<std::uint8_t> listed_taken(listed_in_map_m.size(), 0);
  std::vector<std::uint8_t> landmark_taken(landmarks.size(), 0);
  std::vector<LandmarkPair> pairs;
  for (const LandmarkPair& pair : all) {
    if (listed_taken[pair.listed] != 0 || landmark_taken[pair.landmark] != 0) continue;
    listed_taken[pair.listed] = landmark_taken[pair.landmark] = 1;
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<Eigen::Vector2d> placed(const Pose2& T_map_local,
                                    const std::vector<Eigen::Vector2d>& local_m) {
  std::vector<Eigen::Vector2d> in_map_m;
  for (const Eigen::Vector2d& stem : local_m) in_map_m.push_back(T_map_local * stem);
  return in_map_m;
}

/// The pose that lays the listed stems onto the map's own stems that they are paired with; the
/// given one where fewer than three are.
Pose2 fitted(const Pose2& T_map_local, const std::vector<Eigen::Vector2d>& local_m,
             const std::vector<LandmarkPair>& pairs, const std::vector<MapLandmark>& landmarks) {
  PairSums sums;
  const Eigen::Vector2d origin_m = T_map_local.translation_m;  // for the digits of large numbers
  for (const LandmarkPair& pair : pairs) {
    const MapLandmark& landmark = landmarks[pair.landmark];
    if (!landmark.in_map) continue;
    sums.add(local_m[pair.listed], landmark.position_in_map_m - origin_m, 1.0);
  }
  if (sums.weight < 3.0) return T_map_local;
  const Placement placement = solve(sums, origin_m).placement;
  return {placement.shift_m, placement.yaw_rad()};
}

/// A view of a landmark; an older one from the same place saw what this one sees.
void remember(MapLandmark& landmark, const LandmarkView& view, double spacing_m) {
  std::erase_if(landmark.views, [&](const LandmarkView& older) {
    return (older.from_m - view.from_m).norm() < spacing_m;
  });
  landmark.views.push_back(view);
}

void notice(MapLandmark& landmark, const Eigen::Vector2d& seen_m) {
  ++landmark.sightings;
  if (landmark.in_map) return;
  landmark.position_in_map_m +=
      (seen_m - landmark.position_in_map_m) / static_cast<double>(landmark.sightings);
}

}  // namespace

void describe(SettingsVisitor& v, MapUpdateSettings& s) {
  v.field({"range_m", "m", "stems farther from the sensor are not counted", "choice"}, s.range_m,
          {1, 1000});
  v.field({"field_of_view_deg", "deg", "of the sensor, about its x axis", "Li2020 2.2"},
          s.field_of_view_deg, {1, 360});
  v.field({"pairing_gate_m", "m", "a seen stem this near is the map's", "choice: 3 s.d. of both"},
          s.pairing_gate_m, {0.01, 10});
  v.field({"view_spacing_m", "m", "between counted views: nearer ones share their occlusions",
           "choice"},
          s.view_spacing_m, {0, 1000});
  v.field({"least_paired_share", "", "of the listed stems that a counted view lays on stems",
           "choice: most, as of consensus"},
          s.least_paired_share, {0, 1});
  v.field({"false_match_rate", "", "of views that list something where no stem stands", "choice"},
          s.false_match_rate, {1e-6, 0.4});
  v.field({"decision_ratio", "", "odds to 1 that retire a stem or let one join", "choice"},
          s.decision_ratio, {1, 1e9});
  v.field({"least_sightings", "", "of a stem that joins", "choice"}, s.least_sightings, {1, 1000});
}

MapUpdater::MapUpdater(const std::vector<Eigen::Vector2d>& stems_in_map_m,
                       const MapUpdateSettings& settings)
    : settings_(settings) {
  for (const Eigen::Vector2d& stem : stems_in_map_m) {
    if (!stem.allFinite()) throw UserError("the map to update has a stem that is not finite");
    landmarks_.push_back({stem, true, 0, {}});
  }
}

bool MapUpdater::add_view(const Pose2& T_map_local,
                          const std::vector<Eigen::Vector2d>& stems_in_local_m) {
  const Eigen::Vector2d& place_m = T_map_local.translation_m;
  if (counted_from_m_ && (place_m - *counted_from_m_).norm() < settings_.view_spacing_m) {
    return false;
  }
  std::vector<Eigen::Vector2d> local_m;
  for (const Eigen::Vector2d& stem : stems_in_local_m) {
    if (stem.allFinite() && stem.norm() < settings_.range_m) local_m.push_back(stem);
  }
  // Whatever the list may hold, and what is a little farther: none is founded beside itself.
  const auto near = landmarks_around(place_m, settings_.range_m + 2.0 * settings_.pairing_gate_m);
  const double gate_m = settings_.pairing_gate_m;
  const auto rough = nearest_pairs(placed(T_map_local, local_m), near, landmarks_, gate_m);
  const Pose2 T_map_fitted = fitted(T_map_local, local_m, rough, landmarks_);
  const auto listed_m = placed(T_map_fitted, local_m);
  const auto pairs = nearest_pairs(listed_m, near, landmarks_, gate_m);
  const auto least = settings_.least_paired_share * static_cast<double>(listed_m.size());
  if (static_cast<double>(pairs.size()) < least) return false;
  counted_from_m_ = place_m;
  remember_view(T_map_fitted, near, pairs);
  std::vector<std::uint8_t> known(listed_m.size(), 0);
  for (const LandmarkPair& pair : pairs) {
    known[pair.listed] = 1;
    notice(landmarks_[pair.landmark], listed_m[pair.listed]);
  }
  for (std::size_t i = 0; i < listed_m.size(); ++i) {
    if (known[i] == 0) landmarks_.push_back({listed_m[i], false, 1, {}});
  }
  return true;
}

std::vector<std::size_t> MapUpdater::landmarks_around(const Eigen::Vector2d& place_m,
                                                      double reach_m) const {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    if ((landmarks_[i].position_in_map_m - place_m).norm() < reach_m) near.push_back(i);
  }
  return near;
}

/// What is in view for sure was seen or missed; nearer to the view's edges a miss proves nothing.
void MapUpdater::remember_view(const Pose2& T_map_local, const std::vector<std::size_t>& near,
                               const std::vector<Pair>& pairs) {
  std::vector<std::uint8_t> seen(landmarks_.size(), 0);
  for (const LandmarkPair& pair : pairs) seen[pair.landmark] = 1;
  const Pose2 T_local_map = T_map_local.inverse();
  const double bin_m = settings_.range_m / static_cast<double>(MapLandmark::kRangeBins);
  for (const std::size_t i : near) {
    const Eigen::Vector2d local = T_local_map * landmarks_[i].position_in_map_m;
    if (!is_surely_in_view(local, settings_)) continue;
    const auto bin = static_cast<std::uint8_t>(local.norm() / bin_m);
    remember(landmarks_[i], {T_map_local.translation_m, bin, seen[i] != 0},
             settings_.view_spacing_m);
  }
}

MapUpdate MapUpdater::update() const {
  MapUpdate result;
  result.detection_rate = detection_rates(landmarks_, settings_.false_match_rate);
  const LandmarkEvidence evidence(result.detection_rate, settings_.false_match_rate);
  std::vector<Eigen::Vector2d> joining_m;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const MapLandmark& landmark = landmarks_[i];
    if (!landmark.in_map && landmark.sightings < settings_.least_sightings) continue;
    const bool stands = evidence.stands(landmark, settings_.decision_ratio);
    if (stands) {
      (landmark.in_map ? result.stems_in_map_m : joining_m).push_back(landmark.position_in_map_m);
    } else if (landmark.in_map) {
      result.retired.push_back(i);
    }
  }
  result.added = joining_m.size();
  result.stems_in_map_m.insert(result.stems_in_map_m.end(), joining_m.begin(), joining_m.end());
  return result;
}

}  // namespace honka
