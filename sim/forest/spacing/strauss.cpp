#include "sim/forest/spacing/strauss.h"

#include <cmath>

#include "algo/types/user_error.h"
#include "sim/forest/spacing/torus_grid.h"

namespace honka::sim {
namespace {

constexpr double kForbidden = 1e4;  // energy of a pair that a factor of 0 forbids

/// The stepped pair energy −ln(factor), by squared distance.
class PairEnergy {
 public:
  PairEnergy(const Strauss& settings, double spacing_m) {
    for (std::size_t k = 0; k < settings.radii.size(); ++k) {
      const double radius_m = settings.radii[k] * spacing_m;
      radii2_.push_back(radius_m * radius_m);
      const double factor = settings.factors[k];
      energies_.push_back(factor > 0.0 ? -std::log(factor) : kForbidden);
    }
  }
  [[nodiscard]] double operator()(double distance2) const {
    for (std::size_t k = 0; k < radii2_.size(); ++k) {
      if (distance2 < radii2_[k]) return energies_[k];
    }
    return 0.0;
  }

 private:
  std::vector<double> radii2_, energies_;
};

/// Energy of a stem at a place with all others than `self`.
double energy_at(const TorusGrid& grid, const PairEnergy& pair, const Eigen::Vector2d& place_m,
                 std::size_t self) {
  double sum = 0.0;
  grid.near(place_m, [&](std::size_t index, double distance2) {
    if (index != self) sum += pair(distance2);
  });
  return sum;
}

void check(const Strauss& s) {
  bool rising = !s.radii.empty() && s.radii.size() == s.factors.size() && s.radii[0] > 0.0;
  for (std::size_t k = 1; rising && k < s.radii.size(); ++k) rising = s.radii[k] > s.radii[k - 1];
  if (!rising) {
    throw UserError(
        "forest.spacing.strauss: radii must be positive and rise, with one factor for each; "
        "give two lists of equal length");
  }
}

/// A place half the time near the old one, half the time anywhere.
Eigen::Vector2d propose(const SpacingDomain& domain, const Eigen::Vector2d& old_m,
                        RandomStream& stream) {
  if (stream.uniform() < 0.5) {
    const double x = stream.uniform(domain.box_m.min().x(), domain.box_m.max().x());
    return {x, stream.uniform(domain.box_m.min().y(), domain.box_m.max().y())};
  }
  const double reach_m = 0.5 * domain.spacing_m;
  const double dx = stream.uniform(-reach_m, reach_m);
  return domain.wrapped(old_m + Eigen::Vector2d(dx, stream.uniform(-reach_m, reach_m)));
}

}  // namespace

void describe(SettingsVisitor& v, Strauss& s) {
  v.field({"radii", "s", "outer radii of the steps, in units of s = 1 / √density",
           "fitted to the pair correlation of mature pine plots"},
          s.radii, {1e-6, 3.0});
  v.field({"factors", "", "weight of a pair within each step; 1 indifferent, 0 forbidden",
           "fitted to the pair correlation of mature pine plots"},
          s.factors, {0.0, 10.0});
  v.field({"sweeps", "", "Metropolis moves per stem",
           "choice: Clark–Evans and g(r) are level from 20 on"},
          s.sweeps, {1, 100000});
}

Points Strauss::place(const SpacingDomain& domain, RandomStream& stream) const {
  check(*this);
  const PairEnergy pair(*this, domain.spacing_m);
  TorusGrid grid(domain.box_m, radii.back() * domain.spacing_m);
  for (std::int64_t i = 0; i < domain.count; ++i) grid.add(domain.draw(stream));
  for (const auto& fixed : domain.fixed_m) grid.add(fixed);

  const auto count = static_cast<std::size_t>(domain.count);
  const std::int64_t moves = sweeps * domain.count;
  for (std::int64_t move = 0; move < moves; ++move) {
    const auto index = static_cast<std::size_t>(stream.below(count));
    const Eigen::Vector2d old_m = grid.points_m()[index];
    const Eigen::Vector2d new_m = propose(domain, old_m, stream);
    const double luck = stream.uniform();
    if (!domain.is_free(new_m)) continue;
    const double rise = energy_at(grid, pair, new_m, index) - energy_at(grid, pair, old_m, index);
    if (rise <= 0.0 || luck < std::exp(-rise)) grid.move(index, new_m);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (energy_at(grid, pair, grid.points_m()[i], i) >= kForbidden) {
      throw UserError(
          "forest.spacing.strauss: the stems do not fit at this density; lower "
          "forest.density_per_ha, the radii, or raise the factors above 0");
    }
  }
  return {grid.points_m().begin(), grid.points_m().begin() + domain.count};
}

}  // namespace honka::sim
