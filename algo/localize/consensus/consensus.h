#pragma once

#include <memory>

#include "algo/localize/consensus/index.h"
#include "algo/localize/consensus/settings.h"
#include "algo/localize/matcher.h"

namespace honka {

/// Finds one frame of stems in any map, without a guess, and says so when it is
/// not there: groups of neighbouring stems propose places, all stems weigh
/// them, evidence decides. The folder's README tells how.
class ConsensusMatcher final : public Matcher {
 public:
  /// Throws UserError at settings out of range.
  ConsensusMatcher(std::shared_ptr<const ConsensusIndex> index, ConsensusSettings settings);

  using Matcher::locate;
  [[nodiscard]] LocateResult locate(const std::vector<Eigen::Vector2d>& stems_in_local_m,
                                    const std::optional<LocatePrior>& prior) const override;

 private:
  std::shared_ptr<const ConsensusIndex> index_;
  ConsensusSettings settings_;
};

}  // namespace honka
