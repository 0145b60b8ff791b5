#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "eval/study/shard.h"

namespace honka::eval {

/// Hands trials to workers so that each stays in one world as long as it can: a world (a forest,
/// its scene, its map) costs as much as many trials. A worker without a batch of its own takes half
/// of the longest one left, where that saves more than growing its world again costs.
class TrialQueue {
 public:
  TrialQueue(std::vector<TrialBatch> batches, std::size_t workers);

  /// The next trial of a worker; nothing where the rest is in better hands.
  [[nodiscard]] std::optional<TrialId> next(std::size_t worker);
  /// A trial of a worker's batch has ended and took so long: the first of a batch made its world.
  void ended(std::size_t worker, double wall_s);

 private:
  struct Lane {
    std::deque<TrialId> left;
    std::size_t ended = 0;
    double first_s = 0.0, later_s = 0.0;  ///< of the first trial; of all later ones together
  };
  [[nodiscard]] bool worth_helping(const Lane& lane) const;
  void help(Lane& helper);

  std::deque<TrialBatch> batches_;
  std::vector<Lane> lanes_;
};

}  // namespace honka::eval
