#include "algo/slam/methods/interpolate_pairs.h"

#include <vector>

#include "algo/slam/correction/frame_pair.h"
#include "algo/slam/correction/order.h"
#include "algo/slam/correction/power_coefficients.h"
#include "algo/slam/correction/update.h"

namespace honka {
namespace {

std::vector<FramePair> frame_pairs(std::span<const PairMatch> matches) {
  std::vector<FramePair> pairs;
  for (const PairMatch& match : matches) {
    pairs.push_back({static_cast<std::uint32_t>(match.earlier),
                     static_cast<std::uint32_t>(match.later), 0.0, match.error_m});
  }
  return pairs;
}

}  // namespace

FramePoses interpolate_pairs(const FramePoses& T_first_frame, std::span<const PairMatch> matches,
                             const InterpolatePairsSettings& settings) {
  FramePoses poses = T_first_frame;
  const UpdateSide side = update_side(settings.side);
  const auto order = order_corrections(frame_pairs(matches), correction_order(settings.order), 0);
  for (const std::size_t k : order) {
    const PairMatch& match = matches[k];
    if (match.earlier >= match.later || match.later >= poses.size()) continue;
    const auto shares = power_coefficients(poses, match.earlier, match.later,
                                           PowerCoefficient::kIndex, {}, MotionMetric{});
    apply_correction(poses, {match.earlier, match.later, match.T_earlier_later}, shares, side);
  }
  return poses;
}

}  // namespace honka
