#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace honka::eval {

/// A point is looked at after every so many trials. Each look is one more chance to stop at an
/// interval that is narrow by luck, so few; 50 trials give ±9 % at a rate of 0.9, the widest that
/// is worth stopping at.
inline constexpr std::int64_t kStopLook = 50;

/// Trials after which a point may end; nothing while the intervals are too wide. successes:
/// [method][trial] of the first rate, trials 0..n-1 without gap.
///
/// The smallest multiple of kStopLook at which half the width of Wilson's 95 % interval over the
/// trials before it is at most `half_width` for every method. It depends on those trials alone, not
/// on how many more there are. Nothing for a `half_width` of 0 and for no methods. Ends the program
/// when the methods differ in length.
[[nodiscard]] std::optional<std::int64_t> stopped_after(
    const std::vector<std::vector<std::uint8_t>>& successes, double half_width);

}  // namespace honka::eval
