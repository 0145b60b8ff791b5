#include "algo/odometry/sweep_order.h"

#include <algorithm>
#include <cmath>

namespace honka {

SweepOrder::Verdict SweepOrder::judge(const Sweep& sweep) {
  Verdict verdict;
  if (!std::isfinite(sweep.start_time_s) || !std::isfinite(sweep.start_azimuth_rad)) {
    return {OdometryCause::kNotFinite, false, 0.0};
  }
  if (last_start_s_) {
    verdict.elapsed_s = sweep.start_time_s - *last_start_s_;
    // Two firings of one sensor never start within a thousandth of a revolution.
    if (std::abs(verdict.elapsed_s) < 1e-3 * period_s_) {
      return {OdometryCause::kRepeatedTime, false, 0.0};
    }
    if (verdict.elapsed_s < 0.0) return {OdometryCause::kReversedTime, false, 0.0};
    if (verdict.elapsed_s > 1.5 * period_s_) verdict.cause = OdometryCause::kGap;
  }
  last_start_s_ = sweep.start_time_s;
  const bool empty = std::none_of(sweep.returns.begin(), sweep.returns.end(),
                                  [](const Return& r) { return r.range_ticks > 0; });
  if (empty) verdict.cause = OdometryCause::kEmptyScan;
  return verdict;
}

}  // namespace honka
