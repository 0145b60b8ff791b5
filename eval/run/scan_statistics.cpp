#include "eval/run/scan_statistics.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace honka::eval {

void ScanStatistics::add(std::span<const sim::TruthfulSweep> sweeps) {
  struct Seen {
    std::int64_t hits = 0;
    double range_sum_m = 0.0;
  };
  std::map<std::int32_t, Seen> seen;
  for (const sim::TruthfulSweep& sweep : sweeps) {
    shots += static_cast<std::int64_t>(sweep.truth.size());
    for (const sim::ReturnTruth& truth : sweep.truth) {
      if (truth.label.part == sim::Part::kNone) continue;
      ++returns;
      ++returns_by_part[static_cast<std::size_t>(truth.label.part)];
      if (truth.label.part != sim::Part::kStem) continue;
      Seen& stem = seen[truth.label.owner];
      ++stem.hits;
      stem.range_sum_m += static_cast<double>(truth.range_m);
    }
  }
  ++key_frames;
  for (const auto& [owner, stem] : seen) {
    const double range_m = stem.range_sum_m / static_cast<double>(stem.hits);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (range_m < kRangeEdges_m[bin] || range_m >= kRangeEdges_m[bin + 1]) continue;
      ++stems_hit[bin];
      stem_hits[bin] += stem.hits;
    }
  }
}

void ScanStatistics::merge(const ScanStatistics& other) {
  const auto add = [](auto& sums, const auto& counts) {
    std::transform(sums.begin(), sums.end(), counts.begin(), sums.begin(), std::plus<>());
  };
  key_frames += other.key_frames;
  shots += other.shots;
  returns += other.returns;
  add(returns_by_part, other.returns_by_part);
  add(stems_hit, other.stems_hit);
  add(stem_hits, other.stem_hits);
}

double ScanStatistics::hits_per_stem(std::size_t bin) const {
  if (stems_hit[bin] == 0) return 0.0;
  return static_cast<double>(stem_hits[bin]) / static_cast<double>(stems_hit[bin]);
}

double ScanStatistics::hits_per_stem() const {
  const auto stems = std::accumulate(stems_hit.begin(), stems_hit.end(), std::int64_t{0});
  const auto hits = std::accumulate(stem_hits.begin(), stem_hits.end(), std::int64_t{0});
  return stems == 0 ? 0.0 : static_cast<double>(hits) / static_cast<double>(stems);
}

double ScanStatistics::share_on(sim::Part part) const {
  if (returns == 0) return 0.0;
  return static_cast<double>(returns_by_part[static_cast<std::size_t>(part)]) /
         static_cast<double>(returns);
}

}  // namespace honka::eval
