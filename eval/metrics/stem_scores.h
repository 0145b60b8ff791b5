#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace honka::eval {

/// A found stem and the true stem it stands for.
struct StemPair {
  std::size_t found = 0;  ///< index of the found stem
  std::size_t truth = 0;  ///< index of the true stem
  double distance_m = 0.0;

  bool operator==(const StemPair&) const = default;
};

/// One-to-one pairs within the gate (distance < gate_m), nearest pairs first, equal distances by
/// index; in order of `found`. Stems stand metres apart and the gate is far smaller, so that the
/// greedy choice and the optimal assignment differ only where two found stems share one true one.
[[nodiscard]] std::vector<StemPair> match_stems(std::span<const Eigen::Vector2d> found_m,
                                                std::span<const Eigen::Vector2d> truth_m,
                                                double gate_m);

/// Stems in one frame. `dbh_m` and `ranges_m` are empty or as long as `positions_m`.
struct StemSet {
  std::vector<Eigen::Vector2d> positions_m;
  std::vector<std::optional<double>> dbh_m;
  std::vector<double> ranges_m;  ///< empty: the distance to the sensor
};

/// Counts of a detection; ratios of nothing are nothing.
struct DetectionScore {
  std::int64_t found = 0;          ///< found stems
  std::int64_t found_matched = 0;  ///< of them with a true stem
  std::int64_t truth = 0;          ///< true stems
  std::int64_t truth_matched = 0;  ///< of them found

  [[nodiscard]] std::optional<double> precision() const;
  [[nodiscard]] std::optional<double> recall() const;
  /// Harmonic mean of precision and recall.
  [[nodiscard]] std::optional<double> f1() const;
};

/// Found stems count by their own range, true ones by theirs.
struct RangeScore {
  double low_m = 0.0, high_m = 0.0;  ///< [low, high)
  DetectionScore detection;
};

struct StemScores {
  DetectionScore all;
  std::vector<RangeScore> by_range;
  std::vector<StemPair> pairs;
  std::optional<double> position_rmse_m;    ///< over pairs, 2D
  std::optional<double> radial_bias_m;      ///< mean along the ray; negative: towards the sensor
  std::optional<double> tangential_bias_m;  ///< mean across the ray, counter-clockwise positive
  std::optional<double> dbh_bias_m;         ///< mean of found − true, pairs where both are known
  std::optional<double> dbh_rmse_m;
  std::int64_t dbh_pairs = 0;
};

/// Scores found stems against true ones seen from `sensor_m`. `range_edges_m` rise; stems outside
/// them count in `all` alone.
[[nodiscard]] StemScores score_stems(const StemSet& found, const StemSet& truth,
                                     const Eigen::Vector2d& sensor_m, double gate_m,
                                     const std::vector<double>& range_edges_m = {0, 10, 20, 30, 40,
                                                                                 60});

}  // namespace honka::eval
