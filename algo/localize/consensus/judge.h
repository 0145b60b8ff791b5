#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/localize/consensus/fit.h"
#include "algo/localize/consensus/index.h"
#include "algo/localize/consensus/settings.h"

namespace honka {

/// Weighs places of one frame in a map. Each local stem is the partner of a map
/// stem, or false: p(stem) ∝ w + (1 − w) N(residual; σ²) / ρ, with ρ the map's
/// density there, so that 1 is "as by chance" and a dense thicket is worth no
/// more than an open stand.
class Judge {
 public:
  static constexpr double kHopeless_nats = -8.0;  ///< no refinement makes up for so much

  /// `stems_m`: of the frame, about its middle. `area_m2`: where the frame may
  /// be.
  Judge(const ConsensusIndex& index, const ConsensusSettings& settings,
        std::span<const Eigen::Vector2d> stems_m, double area_m2);

  /// Whether the frame could be told from chance, were all its stems in the map
  /// to the centimetre.
  [[nodiscard]] bool could_accept() const;

  /// What the stems `nearby` (nearest first) say of a fit of a few pairs, in
  /// nats; nothing once they speak against it.
  [[nodiscard]] std::optional<double> hear(const Fit& fit,
                                           std::span<const std::uint32_t> nearby) const;

  /// Pairs, fits and estimates σ in turns until nothing moves or `rounds` are
  /// over, then weighs.
  [[nodiscard]] Fit settle(Fit fit, int rounds) const;
  /// The same in a few rounds; in more where there is hope.
  [[nodiscard]] Fit refine(const Fit& fit) const;

  /// One turn: partners within 3 standard deviations, weights, fit, σ.
  [[nodiscard]] Fit improve(const Fit& fit) const;

  /// A map stem that the fit pairs; some stem of the map when there is none.
  [[nodiscard]] std::uint32_t any_partner(const Fit& fit) const;

  [[nodiscard]] const ConsensusIndex& index() const { return index_; }
  [[nodiscard]] const ConsensusSettings& settings() const { return settings_; }
  [[nodiscard]] std::span<const Eigen::Vector2d> stems() const { return stems_m_; }

  /// Sets evidence_nats and inliers: each map stem explains one local stem at
  /// most.
  void weigh(Fit& fit) const;

 private:
  [[nodiscard]] double price_nats(const Fit& fit) const;
  [[nodiscard]] const std::vector<Eigen::Vector2d>& map() const { return index_.grid().stems(); }
  [[nodiscard]] double density_at(std::int32_t stem) const {
    return index_.groups().densities()[static_cast<std::size_t>(stem)];
  }

  const ConsensusIndex& index_;
  ConsensusSettings settings_;
  std::span<const Eigen::Vector2d> stems_m_;
  double area_m2_;
};

}  // namespace honka
