#pragma once

#include <array>
#include <vector>

#include "algo/localize/map_update.h"

namespace honka {

using RangeRates = std::array<double, MapLandmark::kRangeBins>;

/// How much the views of landmarks speak for them, as natural logarithms of likelihood ratios.
class LandmarkEvidence {
 public:
  /// `rates`: of lists that have a stem which stands, by range; `false_rate`: that have something
  /// where none does.
  LandmarkEvidence(const RangeRates& rates, double false_rate);

  /// "It stands" over "nothing ever stood there". How visible this stem is among others is not
  /// known: most are as visible as the rates say, a tenth half as much.
  [[nodiscard]] double stands_over_never(const MapLandmark& landmark) const;
  /// "It stood and is gone since one of the views", the likeliest one, over "it stands". 0 without
  /// a view.
  [[nodiscard]] double gone_over_stands(const MapLandmark& landmark) const;

 private:
  static constexpr std::size_t kVisibilities = 2;
  using ByVisibility = std::array<double, kVisibilities>;
  [[nodiscard]] static double log_sum(const ByVisibility& logs);
  [[nodiscard]] const ByVisibility& log_stands(const LandmarkView& view) const {
    return stands_[view.bin][view.seen ? 1 : 0];
  }
  [[nodiscard]] double log_never(const LandmarkView& view) const {
    return never_[view.seen ? 1 : 0];
  }

  std::array<std::array<ByVisibility, 2>, MapLandmark::kRangeBins> stands_;  ///< missed, seen
  std::array<double, 2> never_;
};

/// The rates that make the views of the map's stems most likely, where each stands or does not and
/// which of them is not known (expectation maximisation). What hides stems is in them.
[[nodiscard]] RangeRates detection_rates(const std::vector<MapLandmark>& landmarks,
                                         double false_rate);

}  // namespace honka
