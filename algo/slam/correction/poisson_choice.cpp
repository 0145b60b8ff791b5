#include "algo/slam/correction/poisson_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace honka {
namespace {

/// ε shrinks by this (Nevalainen2021 §2.4, step 2) …
constexpr double kShrink = 0.8;
/// … down to where every pair has a grid point of its own.
constexpr double kFinestSpacing = 0.5;

using GridPoint = std::array<double, 2>;  ///< whole numbers of ε along j and i

std::vector<GridPoint> rounded_set(std::span<const FramePair> pairs, double spacing) {
  std::vector<GridPoint> points;
  points.reserve(pairs.size());
  for (const FramePair& pair : pairs) {
    points.push_back({std::round(pair.j / spacing), std::round(pair.i / spacing)});
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

double first_spacing(std::span<const FramePair> pairs, std::int64_t wanted) {
  const auto [low_j, high_j] = std::minmax_element(
      pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.j < b.j; });
  const auto [low_i, high_i] = std::minmax_element(
      pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.i < b.i; });
  // A box without width is given that of one frame.
  const double area = std::max(1.0, static_cast<double>(high_j->j - low_j->j)) *
                      std::max(1.0, static_cast<double>(high_i->i - low_i->i));
  return std::max(kFinestSpacing, std::sqrt(area / static_cast<double>(wanted)));
}

double spacing_for(std::span<const FramePair> pairs, std::int64_t wanted) {
  double best = first_spacing(pairs, wanted);
  auto least = std::numeric_limits<std::int64_t>::max();
  for (double spacing = best; spacing >= kFinestSpacing; spacing *= kShrink) {
    const auto size = static_cast<std::int64_t>(rounded_set(pairs, spacing).size());
    const std::int64_t miss = std::abs(size - wanted);
    if (miss < least) {
      least = miss;
      best = spacing;
    }
    if (size >= wanted) break;
  }
  return best;
}

std::size_t nearest_pair(std::span<const FramePair> pairs, const GridPoint& point, double spacing) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double dj = pairs[k].j - point[0] * spacing, di = pairs[k].i - point[1] * spacing;
    const double squared = dj * dj + di * di;
    if (squared < least) {
      least = squared;
      nearest = k;
    }
  }
  return nearest;
}

}  // namespace

PoissonChoice choose_near_poisson(std::span<const FramePair> pairs, std::int64_t wanted) {
  PoissonChoice choice;
  if (pairs.empty() || wanted < 1) return choice;
  choice.spacing = spacing_for(pairs, wanted);
  // Nevalainen2021 Eq. (28)
  const std::vector<GridPoint> grid_points = rounded_set(pairs, choice.spacing);
  choice.grid_points = static_cast<std::int64_t>(grid_points.size());
  // Nevalainen2021 Eq. (29)
  for (const GridPoint& point : grid_points) {
    choice.chosen.push_back(nearest_pair(pairs, point, choice.spacing));
  }
  std::sort(choice.chosen.begin(), choice.chosen.end());
  choice.chosen.erase(std::unique(choice.chosen.begin(), choice.chosen.end()), choice.chosen.end());
  return choice;
}

}  // namespace honka
