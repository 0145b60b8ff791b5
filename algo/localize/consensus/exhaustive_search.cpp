#include "algo/localize/consensus/exhaustive_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <tuple>

namespace honka {
namespace {

constexpr double kVoteCell_m = 1.0;
constexpr std::size_t kMostStems = 36;    // of the frame, around its middle
constexpr std::size_t kMostPeaks = 1000;  // chance peaks of 14 stems on 2,200 outnumber the true
constexpr std::size_t kMostCells = 1 << 22;

/// A window of 2 × 2 cells that got many votes under one turn.
struct Peak {
  int votes = 0;
  int turn = 0;
  std::uint32_t cell = 0;
  auto operator<=>(const Peak&) const = default;
};

/// The votes of one turn after the other, over the box of the map.
class TurnVotes {
 public:
  TurnVotes(std::span<const Eigen::Vector2d> stems_m, const std::vector<Eigen::Vector2d>& map_m)
      : stems_m_(stems_m) {
    low_m_ = high_m_ = map_m[0];
    for (const Eigen::Vector2d& p : map_m) {
      low_m_ = low_m_.cwiseMin(p);
      high_m_ = high_m_.cwiseMax(p);
    }
    constexpr double kMargin_m = 5.0;  // the middle of a frame may lie beside the map
    low_m_.array() -= kMargin_m;
    high_m_.array() += kMargin_m;
    double squares_m2 = 0.0;
    for (const Eigen::Vector2d& q : stems_m) squares_m2 += q.squaredNorm();
    const double rms_m = std::sqrt(squares_m2 / static_cast<double>(stems_m.size()));
    // Half a step moves an outer stem (1.4 rms) by half a cell.
    turns_ = std::max(8, static_cast<int>(2.0 * std::numbers::pi * 1.4 * rms_m / kVoteCell_m));
  }

  [[nodiscard]] int turns() const { return turns_; }
  [[nodiscard]] double step_rad() const { return 2.0 * std::numbers::pi / turns_; }
  [[nodiscard]] double cells() const {
    return (high_m_ - low_m_).x() * (high_m_ - low_m_).y() / (kVoteCell_m * kVoteCell_m);
  }

  std::vector<Peak> highest(const std::vector<Eigen::Vector2d>& map_m) {
    prepare(map_m);
    for (int turn = 0; turn < turns_; ++turn) {
      vote(turn);
      keep_peaks(turn);
    }
    std::sort(peaks_.begin(), peaks_.end(), std::greater<>());
    return peaks_;
  }

  /// Uncertain by the width of a window and a step of turn.
  [[nodiscard]] Fit fit_of(const Peak& peak) const {
    constexpr double kSigma_m = 0.3;
    constexpr double kWindow_m2 = 0.2;
    Fit fit;
    fit.placement = placement(peak.turn);
    fit.placement.shift_m =
        low_m_ + kVoteCell_m * Eigen::Vector2d(peak.cell % width_ + 1, peak.cell / width_ + 1);
    fit.sigma_m = kSigma_m;
    fit.weight = kSigma_m * kSigma_m / kWindow_m2;
    fit.spread_m2 = std::pow(2.0 * kSigma_m / step_rad(), 2);
    return fit;
  }

 private:
  [[nodiscard]] Placement placement(int turn) const {
    return {std::cos(turn * step_rad()), std::sin(turn * step_rad()), Eigen::Vector2d::Zero()};
  }

  void prepare(const std::vector<Eigen::Vector2d>& map_m) {
    width_ = static_cast<std::uint32_t>((high_m_ - low_m_).x() / kVoteCell_m) + 2;
    height_ = static_cast<std::uint32_t>((high_m_ - low_m_).y() / kVoteCell_m) + 2;
    votes_.resize(std::size_t{width_ + 2} * (height_ + 2));
    window_.resize(width_);
    for (const Eigen::Vector2d& p : map_m) {
      const Eigen::Vector2d cell = (p - low_m_) / kVoteCell_m;
      map_x_.push_back(static_cast<float>(cell.x()));
      map_y_.push_back(static_cast<float>(cell.y()));
    }
    slots_.resize(map_m.size());
  }

  /// A frame of cells around the box takes the votes outside it, so that no vote is asked where it
  /// falls: numbers of slots first, many at a time, then the counts.
  void vote(int turn) {
    std::fill(votes_.begin(), votes_.end(), std::int16_t{0});
    for (const Eigen::Vector2d& q : stems_m_) {
      const Eigen::Vector2f at = (placement(turn).turned(q) / kVoteCell_m).cast<float>();
      number_slots(at);
      for (const std::int32_t slot : slots_) ++votes_[static_cast<std::size_t>(slot)];
    }
  }

  /// Of the votes of a turned stem; whole numbers in float, which four at a time are made of.
  void number_slots(const Eigen::Vector2f& at) {
    const auto within = [](float value, float most) {
      const float low = value > -1.0F ? value : -1.0F;
      return low < most ? low : most;
    };
    const float at_x = at.x();
    const float at_y = at.y();
    const auto columns = static_cast<float>(width_);
    const auto rows = static_cast<float>(height_);
    const float stride = columns + 2.0F;
    const float* x = map_x_.data();
    const float* y = map_y_.data();
    std::int32_t* slots = slots_.data();
    const std::size_t count = slots_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto column = static_cast<std::int32_t>(within(x[k] - at_x, columns));
      const auto row = static_cast<std::int32_t>(within(y[k] - at_y, rows));
      slots[k] = static_cast<std::int32_t>((static_cast<float>(row) + 1.0F) * stride +
                                           (static_cast<float>(column) + 1.0F));
    }
  }

  void keep_peaks(int turn) {
    for (std::uint32_t row = 0; row + 1 < height_; ++row) {
      const std::int16_t* here = &votes_[std::size_t{row + 1} * (width_ + 2) + 1];
      const std::int16_t* above = here + width_ + 2;
      std::int16_t most = 0;
      for (std::uint32_t c = 0; c + 1 < width_; ++c) {
        window_[c] = static_cast<std::int16_t>(here[c] + here[c + 1] + above[c] + above[c + 1]);
        most = std::max(most, window_[c]);
      }
      if (most >= least_) keep_row(turn, row);
    }
  }

  void keep_row(int turn, std::uint32_t row) {
    const int stems = static_cast<int>(stems_m_.size());
    for (std::uint32_t c = 0; c + 1 < width_; ++c) {
      if (window_[c] < least_) continue;
      add({std::min<int>(window_[c], stems), turn, row * width_ + c});
    }
  }

  void add(const Peak& peak) {
    peaks_.push_back(peak);
    std::push_heap(peaks_.begin(), peaks_.end(), std::greater<>());
    if (peaks_.size() <= kMostPeaks) return;
    std::pop_heap(peaks_.begin(), peaks_.end(), std::greater<>());
    peaks_.pop_back();
    least_ = peaks_.front().votes + 1;
  }

  std::span<const Eigen::Vector2d> stems_m_;
  Eigen::Vector2d low_m_, high_m_;
  int turns_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
  std::vector<float> map_x_, map_y_;  ///< in cells
  std::vector<std::int32_t> slots_;   ///< of one stem's votes
  std::vector<std::int16_t> votes_, window_;
  std::vector<Peak> peaks_;  ///< a heap, the lowest at the front
  int least_ = 3;
};

}  // namespace

std::int64_t search_exhaustively(const Judge& judge, const LocalFrame& frame,
                                 const std::vector<Eigen::Vector2d>& map_m, const Allowed& allows,
                                 PlaceList& places) {
  if (map_m.empty()) return 0;
  const auto stems = std::span(frame.stems_m).first(std::min(frame.stems_m.size(), kMostStems));
  TurnVotes votes(stems, map_m);
  const double cost = static_cast<double>(stems.size() * map_m.size()) * votes.turns();
  if (cost > judge.settings().exhaustive_votes || votes.cells() > kMostCells) return 0;
  std::vector<std::uint32_t> witnesses(std::min<std::size_t>(stems.size(), 24));
  std::iota(witnesses.begin(), witnesses.end(), 0U);
  std::int64_t refined = 0;
  for (const Peak& peak : votes.highest(map_m)) {
    const Fit fit = votes.fit_of(peak);
    if (!judge.hear(fit, witnesses) || places.knows(fit.placement)) continue;
    const Fit fine = judge.refine(fit);
    ++refined;
    if (allows(fine.placement)) places.add(fine);
  }
  return refined;
}

}  // namespace honka
