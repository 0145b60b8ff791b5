#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/study/study.h"

namespace honka::eval {

/// A part of a study that one process works on: number `index` of `count`.
struct Shard {
  std::int64_t index = 0, count = 1;

  bool operator==(const Shard&) const = default;
};

/// "2/7" with 0 <= 2 < 7. UserError otherwise.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// Which of `count` shards a trial belongs to: the same however many trials a study has, so that
/// more can be added. Trials of a world stay together in batches, which the shards take in turn.
[[nodiscard]] std::int64_t shard_of(const Study& study, TrialId id, std::int64_t count);

/// Trials that follow each other in one worker, all in one world.
using TrialBatch = std::vector<TrialId>;

/// The trials of a shard in the order in which they are best run: point by point, and there world
/// by world. Where points may stop early, their trials come in rounds, so that the first ones are
/// complete before many more have been run.
[[nodiscard]] std::vector<TrialBatch> batches_of(const Study& study, const Shard& shard);

}  // namespace honka::eval
