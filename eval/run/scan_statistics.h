#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sim/world/recording.h"

namespace honka::eval {

/// How hard the world is to see: what the returns of key frames fell on. Truth, for the report.
struct ScanStatistics {
  /// Edges of the range bins, those of "hits per tree" in the literature. Metres.
  static constexpr std::array<double, 5> kRangeEdges_m = {0.0, 10.0, 20.0, 30.0, 47.0};
  static constexpr std::size_t kBins = kRangeEdges_m.size() - 1;

  std::int64_t key_frames = 0;
  std::int64_t shots = 0;
  std::int64_t returns = 0;
  std::array<std::int64_t, sim::kPartCount> returns_by_part{};
  std::array<std::int64_t, kBins> stems_hit{};  ///< (key frame, tree) pairs by mean range
  std::array<std::int64_t, kBins> stem_hits{};  ///< returns on them

  /// Adds the sweeps of one key frame.
  void add(std::span<const sim::TruthfulSweep> sweeps);
  /// Adds the counts of other key frames.
  void merge(const ScanStatistics& other);
  /// Mean hits a stem in a bin; 0 where no stem was hit.
  [[nodiscard]] double hits_per_stem(std::size_t bin) const;
  /// Mean over all ranges.
  [[nodiscard]] double hits_per_stem() const;
  [[nodiscard]] double share_on(sim::Part part) const;
};

}  // namespace honka::eval
