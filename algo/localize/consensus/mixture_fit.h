#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "algo/localize/consensus/judge.h"
#include "algo/localize/consensus/partners.h"

namespace honka {

/// What a fit with unknown partners estimates.
struct MixtureState {
  Placement T_map_sensor;
  double radial_bias_m = 0.0;  ///< listed stems lie so much too near to the sensor
  bool biased = false;         ///< whether that is estimated
  /// (xx, yy, xy) of the symmetric part of what listed places are stretched by: a list that was
  /// not levelled is too long along the slope.
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  double sigma_m = 0.0, false_share = 0.3;
};

/// Unknowns of a fit: shift of the sensor along its own axes, turn, radial bias; then the strain.
inline constexpr int kWithoutStrain = 4;
inline constexpr int kWithStrain = 7;

/// A state with what is known of its error.
template <int N>
struct MixtureEstimate : MixtureState {
  using Information = Eigen::Matrix<double, N, N>;
  Information given_partners = Information::Zero();  ///< times σ²
  Information lost = Information::Zero();            ///< times σ⁴: partners are not given

  MixtureEstimate() = default;
  explicit MixtureEstimate(const MixtureState& state) : MixtureState(state) {}

  /// Whole or, where the loss takes too much of it, that of given partners.
  [[nodiscard]] Information covariance() const {
    const double variance = sigma_m * sigma_m;
    const Information whole = given_partners / variance - lost / (variance * variance);
    const Eigen::LLT<Information> roots(whole);
    if (roots.info() == Eigen::Success) return roots.solve(Information::Identity());
    return variance * given_partners.ldlt().solve(Information::Identity());
  }
};

/// Maximum likelihood around a settled fit where every local stem is any of the map stems around
/// it, or false, and no map stem is two: partners and unknowns in turns.
class MixtureFit {
 public:
  /// `sensor_in_frame_m`: unknowns are those of the sensor, the arm of the turn begins there.
  MixtureFit(const Judge& judge, const Eigen::Vector2d& sensor_in_frame_m);

  /// Until nothing moves. Nothing where this leads away from the place, or to a bias or a strain
  /// that no list has.
  template <int N>
  [[nodiscard]] std::optional<MixtureEstimate<N>> run(const MixtureState& start);

  /// How far the strain of one step from a state is from none: squared, in standard deviations of
  /// its three numbers.
  [[nodiscard]] double strain_squared_sds(const MixtureState& at);

 private:
  /// A local stem: place, and unit vector of the line of sight.
  struct SeenStem {
    Eigen::Vector2d in_sensor_m, along;
  };
  template <int N>
  struct Step;

  [[nodiscard]] static Eigen::Vector2d corrected(const SeenStem& seen, const MixtureState& at);
  void gather(const MixtureState& at);
  void weigh_pairs(const MixtureState& at);
  template <int N>
  [[nodiscard]] Step<N> step_from(MixtureEstimate<N>& at) const;
  template <int N>
  [[nodiscard]] double improve(MixtureEstimate<N>& at) const;
  [[nodiscard]] double update_noise(MixtureState& at, double fitted, double weight,
                                    double squares_m2) const;

  const Judge& judge_;
  std::vector<SeenStem> seen_;
  std::vector<std::uint32_t> map_;  ///< index of the grid, of each stem that `map` counts
  std::vector<PossiblePair> pairs_;
  std::vector<Eigen::Vector2d> residuals_m_;
};

}  // namespace honka
