#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {

/// Mean, s.d. and greatest of some errors; nothing where too few.
struct ErrorStatistics {
  std::optional<double> mean, sd, max;
};

/// All windows of one variant seen through so many frames.
struct LocalizationSummary {
  std::string variant, map, method;
  bool repaired = false;
  std::int64_t stems_in_map = 0;  ///< the greatest over trials
  double tolerance_m2 = 0.0;
  std::int64_t frames = 0;
  std::int64_t windows = 0, accepted = 0, successes = 0;
  double trunks = 0.0, matches = 0.0;         ///< means over windows
  double local_stars = 0.0, surviving = 0.0;  ///< means over windows
  Interval success_interval;                  ///< Wilson, 95 %, over disjoint windows
  std::optional<Interval> stands_interval;    ///< bootstrap over stands, 95 %
  ErrorStatistics translation_m, rotation_deg, to_odometry_m;  ///< of the successes
  std::optional<double> error_over_bound;  ///< RMS error of successes over the RMS bound
  std::optional<double> in_map_rms_m, in_map_bound_m;  ///< to the map as it lies there
  double online_p50_ms = 0.0, online_p95_ms = 0.0;     ///< gathering, Algorithm 1, matching
  double match_p50_ms = 0.0, match_p95_ms = 0.0;
  double aggregate_p50_ms = 0.0, extract_p50_ms = 0.0;
  double keeps_up_m_s = 0.0;  ///< speed at which a key frame comes every online_p95

  [[nodiscard]] double success_rate() const { return share(successes); }
  [[nodiscard]] double accepted_rate() const { return share(accepted); }
  [[nodiscard]] double wrong_rate() const { return share(accepted - successes); }
  [[nodiscard]] std::optional<double> in_map_over_bound() const {
    if (!in_map_rms_m || !in_map_bound_m || *in_map_bound_m <= 0.0) return std::nullopt;
    return *in_map_rms_m / *in_map_bound_m;
  }

 private:
  [[nodiscard]] double share(std::int64_t count) const {
    return windows == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(windows);
  }
};

/// One summary a (variant, frames) in the order of first appearance in the rows.
[[nodiscard]] std::vector<LocalizationSummary> summarize(const Table& frames,
                                                         const Scenario& scenario);

/// Stems found by range over all windows of a (variant, frames).
struct DetectionSummary {
  std::string variant;
  std::int64_t frames = 0;
  struct Bin {
    double low_m = 0.0, high_m = 0.0;
    std::int64_t found = 0, found_true = 0, trees = 0, trees_found = 0;
  };
  std::vector<Bin> bins;
  std::optional<double> stem_rmse_m;  ///< pooled over windows by their true stems
};

/// For the variants whose chain differs: "default" and "repaired".
[[nodiscard]] std::vector<DetectionSummary> summarize_detection(const Table& frames);

}  // namespace honka::eval
