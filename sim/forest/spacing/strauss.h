#pragma once

#include "algo/types/settings.h"
#include "sim/forest/spacing/domain.h"

namespace honka::sim {

/// Soft-core spacing: a Gibbs process with a stepped pair interaction (a multiscale Strauss
/// process), sampled with a fixed number of stems by Metropolis moves.
///
/// A pair at a distance r with radii[k − 1] ≤ r / s < radii[k] weighs factors[k] in the probability
/// of a stand; 1 is indifference, 0 forbids. Distances are in units of s = 1 / √density, so that
/// one set of numbers serves all densities.
struct Strauss {
  static constexpr std::string_view kName = "strauss";
  std::vector<double> radii = {0.08, 0.15, 0.25, 0.35, 0.45, 0.55, 0.8, 1.1};
  std::vector<double> factors = {0.0, 0.13, 0.2, 0.4, 0.67, 0.95, 1.17, 1.16};
  std::int64_t sweeps = 60;

  /// UserError when pairs stay nearer than a factor of 0 allows.
  [[nodiscard]] Points place(const SpacingDomain& domain, RandomStream& stream) const;
};
void describe(SettingsVisitor& v, Strauss& s);

}  // namespace honka::sim
