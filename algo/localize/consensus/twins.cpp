#include "algo/localize/consensus/twins.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace honka {

void add_twins(const Judge& judge, const Fit& fit, const Allowed& allows, PlaceList& places) {
  constexpr std::size_t kNeighbours = 20;  // two rows and stems to each side
  constexpr std::size_t kWitnesses = 24;   // around the middle of the frame
  constexpr double kReach_m = 15.0;
  constexpr double kSigma_m = 0.3;  // of stems that only stand in the same pattern
  const StemGrid& grid = judge.index().grid();
  const std::uint32_t stem = judge.any_partner(fit);  // nearest to the middle of the frame
  std::vector<std::pair<double, std::uint32_t>> around;
  grid.nearest_others(stem, kNeighbours, kReach_m, around);
  std::vector<std::uint32_t> witnesses(std::min(kWitnesses, judge.stems().size()));
  std::iota(witnesses.begin(), witnesses.end(), 0U);
  for (const auto& [squared_m2, other] : around) {
    Fit twin = fit;
    twin.placement.shift_m += grid.stems()[other] - grid.stems()[stem];
    twin.sigma_m = kSigma_m;
    if (!allows(twin.placement) || !judge.hear(twin, witnesses)) continue;
    places.add(judge.refine(twin));
  }
}

}  // namespace honka
