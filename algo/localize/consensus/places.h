#pragma once

#include <span>
#include <vector>

#include "algo/localize/consensus/fit.h"

namespace honka {

/// Distinct places with their evidence, for "which is best, and is another
/// about as good?".
class PlaceList {
 public:
  /// Keeps the better of two fits of one place (within 1 m and 3°), and none
  /// without hope.
  void add(const Fit& fit);
  /// Whether a place of the list is within a step of refinement of this one.
  [[nodiscard]] bool knows(const Placement& placement) const;
  [[nodiscard]] const Fit* best() const;
  /// Evidence of the best over chance and over the runner-up. Where places
  /// beyond chance form a pattern (planted rows), over what the best of their
  /// kind could reach by luck.
  [[nodiscard]] double margin_nats(double beyond_chance_nats) const;
  /// Places of so much evidence, without the best.
  [[nodiscard]] std::size_t rivals(double least_nats) const;
  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  std::vector<Fit> places_;
};

}  // namespace honka
