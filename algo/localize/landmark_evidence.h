#pragma once

#include <array>
#include <vector>

#include "algo/localize/map_update.h"

namespace honka {

using RangeRates = std::array<double, MapLandmark::kRangeBins>;

/// What the views of landmarks say of them.
class LandmarkEvidence {
 public:
  /// `rates`: of lists that have a stem which stands, by range; `false_rate`: that have something
  /// where none does.
  LandmarkEvidence(const RangeRates& rates, double false_rate);

  /// "It stands" over "nothing ever stood there", a likelihood ratio, at most 1e30. How visible
  /// this stem is among others is not known: most are as visible as the rates say, some half as
  /// much.
  [[nodiscard]] double stands_over_never(const MapLandmark& landmark) const;

  /// Whether it stands after its last view. A stem of the map does until the odds are
  /// `decision_ratio` to 1 that it is gone, one that would join does not until they are that high
  /// that it stands; what is so decided holds until they are for the opposite. It may have been
  /// felled before any of the views.
  [[nodiscard]] bool stands(const MapLandmark& landmark, double decision_ratio) const;

 private:
  /// Gone, visible, hardly visible.
  using ByState = std::array<double, 3>;
  [[nodiscard]] const ByState& likelihood(const LandmarkView& view) const {
    return likelihood_[view.bin][view.seen ? 1 : 0];
  }

  std::array<std::array<ByState, 2>, MapLandmark::kRangeBins> likelihood_;  ///< missed, seen
};

/// The rates that make the views of the map's stems most likely, where each stands or does not and
/// which of them is not known (expectation maximisation). What hides stems is in them.
[[nodiscard]] RangeRates detection_rates(const std::vector<MapLandmark>& landmarks,
                                         double false_rate);

}  // namespace honka
