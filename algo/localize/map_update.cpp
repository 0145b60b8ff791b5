#include "algo/localize/map_update.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/types/user_error.h"

namespace honka {
namespace {

using RangeRates = std::array<double, MapLandmark::kRangeBins>;

/// log P(sightings | stands) − log P(sightings | gone).
double standing_ratio(const MapLandmark& landmark, const RangeRates& rates, double false_rate) {
  double ratio = 0.0;
  for (std::size_t bin = 0; bin < rates.size(); ++bin) {
    const auto seen = static_cast<double>(landmark.seen[bin]);
    const double missed = static_cast<double>(landmark.expected[bin]) - seen;
    ratio += seen * std::log(rates[bin] / false_rate);
    ratio += missed * std::log((1.0 - rates[bin]) / (1.0 - false_rate));
  }
  return ratio;
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
  v.field({"false_match_rate", "", "of views that list something where no stem stands", "choice"},
          s.false_match_rate, {1e-6, 0.5});
  v.field({"decision_ratio", "", "likelihood ratio that retires a stem or lets one join", "choice"},
          s.decision_ratio, {1, 1e12});
  v.field({"least_sightings", "", "of a stem that joins", "choice"}, s.least_sightings, {1, 1000});
}

std::int64_t MapLandmark::sightings() const {
  return std::accumulate(seen.begin(), seen.end(), std::int64_t{0});
}

MapUpdater::MapUpdater(const std::vector<Eigen::Vector2d>& stems_in_map_m,
                       const MapUpdateSettings& settings)
    : settings_(settings) {
  for (const Eigen::Vector2d& stem : stems_in_map_m) {
    if (!stem.allFinite()) throw UserError("the map to update has a stem that is not finite");
    MapLandmark landmark;
    landmark.position_in_map_m = stem;
    landmark.in_map = true;
    landmarks_.push_back(landmark);
  }
}

std::vector<MapUpdater::InView> MapUpdater::landmarks_in_view(const Pose2& T_map_local) const {
  const Pose2 T_local_map = T_map_local.inverse();
  const double half_view_rad = 0.5 * deg_to_rad(settings_.field_of_view_deg);
  const double bin_m = settings_.range_m / static_cast<double>(MapLandmark::kRangeBins);
  std::vector<InView> in_view;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const Eigen::Vector2d local = T_local_map * landmarks_[i].position_in_map_m;
    const double range_m = local.norm();
    if (range_m >= settings_.range_m) continue;
    if (std::abs(std::atan2(local.y(), local.x())) > half_view_rad) continue;
    in_view.push_back({i, static_cast<std::size_t>(range_m / bin_m)});
  }
  return in_view;
}

bool MapUpdater::add_view(const Pose2& T_map_local,
                          const std::vector<Eigen::Vector2d>& stems_in_local_m) {
  const Eigen::Vector2d& place_m = T_map_local.translation_m;
  if (counted_from_m_ && (place_m - *counted_from_m_).norm() < settings_.view_spacing_m) {
    return false;
  }
  counted_from_m_ = place_m;
  // Each seen stem is that of the nearest landmark, or a new one; all in view are expected.
  std::vector<std::uint8_t> seen(landmarks_.size(), 0);
  const auto in_view = landmarks_in_view(T_map_local);
  for (const Eigen::Vector2d& local : stems_in_local_m) {
    if (!local.allFinite() || local.norm() >= settings_.range_m) continue;
    const Eigen::Vector2d stem_m = T_map_local * local;
    double nearest_m = settings_.pairing_gate_m;
    std::size_t nearest = landmarks_.size();
    for (const InView& one : in_view) {
      const double away_m = (landmarks_[one.landmark].position_in_map_m - stem_m).norm();
      if (away_m >= nearest_m) continue;
      nearest_m = away_m;
      nearest = one.landmark;
    }
    if (nearest < seen.size()) {
      seen[nearest] = 1;
    } else {
      MapLandmark landmark;
      landmark.position_in_map_m = stem_m;
      landmarks_.push_back(landmark);  // counted from the next view on: this one founded it
    }
  }
  for (const InView& one : in_view) {
    ++landmarks_[one.landmark].expected[one.bin];
    landmarks_[one.landmark].seen[one.bin] += seen[one.landmark];
  }
  return true;
}

/// Of the stems that were seen twice, and so stand. What hides stems hides these as well.
RangeRates MapUpdater::detection_rates() const {
  RangeRates rates{};
  for (std::size_t bin = 0; bin < rates.size(); ++bin) {
    double expected = 2.0;  // a rate of one half where nothing is known
    double seen = 1.0;
    for (const MapLandmark& landmark : landmarks_) {
      if (landmark.sightings() < 2) continue;
      expected += static_cast<double>(landmark.expected[bin]);
      seen += static_cast<double>(landmark.seen[bin]);
    }
    rates[bin] = std::clamp(seen / expected, 2.0 * settings_.false_match_rate, 0.95);
  }
  return rates;
}

MapUpdate MapUpdater::update() const {
  const double decision = std::log(settings_.decision_ratio);
  MapUpdate result;
  result.detection_rate = detection_rates();
  std::vector<Eigen::Vector2d> joining_m;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const MapLandmark& landmark = landmarks_[i];
    const double ratio =
        standing_ratio(landmark, result.detection_rate, settings_.false_match_rate);
    if (landmark.in_map && ratio < -decision) {
      result.retired.push_back(i);
    } else if (landmark.in_map) {
      result.stems_in_map_m.push_back(landmark.position_in_map_m);
    } else if (ratio > decision && landmark.sightings() + 1 >= settings_.least_sightings) {
      joining_m.push_back(landmark.position_in_map_m);
    }
  }
  result.added = joining_m.size();
  result.stems_in_map_m.insert(result.stems_in_map_m.end(), joining_m.begin(), joining_m.end());
  return result;
}

}  // namespace honka
