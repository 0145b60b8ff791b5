#include "algo/localize/consensus/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "algo/types/user_error.h"

namespace honka {

void check_finite(std::span<const Eigen::Vector2d> stems_m) {
  for (std::size_t i = 0; i < stems_m.size(); ++i) {
    if (stems_m[i].allFinite()) continue;
    throw UserError(fmt::format("point {} of {} is not finite; remove it or mend its line", i + 1,
                                stems_m.size()));
  }
}

LocalFrame make_frame(std::span<const Eigen::Vector2d> stems_in_local_m) {
  check_finite(stems_in_local_m);
  LocalFrame frame;
  frame.stems_m.assign(stems_in_local_m.begin(), stems_in_local_m.end());
  const auto by_place = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  };
  std::sort(frame.stems_m.begin(), frame.stems_m.end(), by_place);
  frame.stems_m.erase(std::unique(frame.stems_m.begin(), frame.stems_m.end()), frame.stems_m.end());
  for (const Eigen::Vector2d& p : frame.stems_m) {
    frame.middle_m += p / static_cast<double>(frame.stems_m.size());
  }
  for (Eigen::Vector2d& p : frame.stems_m) p -= frame.middle_m;
  std::stable_sort(frame.stems_m.begin(), frame.stems_m.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  return frame;
}

double LocalFrame::width_m() const {
  if (stems_m.empty()) return 0.0;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : stems_m) scatter += p * p.transpose();
  scatter /= static_cast<double>(stems_m.size());
  const double half = 0.5 * scatter.trace();
  const double apart = std::hypot(0.5 * (scatter(0, 0) - scatter(1, 1)), scatter(0, 1));
  return std::sqrt(std::max(half - apart, 0.0));
}

void LocalFrame::nearest(std::uint32_t stem, std::size_t count,
                         std::vector<std::uint32_t>& found) const {
  thread_local std::vector<std::pair<double, std::uint32_t>> by_distance;
  by_distance.clear();
  for (std::uint32_t j = 0; j < stems_m.size(); ++j) {
    if (j != stem) by_distance.emplace_back((stems_m[j] - stems_m[stem]).squaredNorm(), j);
  }
  const std::size_t kept = std::min(count, by_distance.size());
  std::partial_sort(by_distance.begin(), by_distance.begin() + static_cast<std::ptrdiff_t>(kept),
                    by_distance.end());
  found.clear();
  for (std::size_t k = 0; k < kept; ++k) found.push_back(by_distance[k].second);
}

}  // namespace honka
