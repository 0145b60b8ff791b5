#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/correction/frame_pair.h"

namespace honka {

/// The order in which corrections are applied.
enum class CorrectionOrder : std::uint8_t {
  kSmallGapsFirst,   ///< ascending gap
  kMediumGapsFirst,  ///< ascending |gap − median gap|
  kRandom,
};

/// small_gaps_first | medium_gaps_first | random, in this order.
[[nodiscard]] const std::vector<std::string>& correction_order_names();
/// HONKA_CHECKs that the name is one of these.
[[nodiscard]] CorrectionOrder correction_order(const std::string& name);

/// A permutation of the pairs' indices; of equal keys the lower index first. The seed counts for
/// kRandom alone. The median of an even number is the mean of the middle two.
/// Source: Nevalainen2021 §3, Table 1.
[[nodiscard]] std::vector<std::size_t> order_corrections(std::span<const FramePair> pairs,
                                                         CorrectionOrder order, std::uint64_t seed);

}  // namespace honka
