#pragma once

#include <functional>
#include <vector>

#include "eval/study/shard.h"
#include "eval/study/worker.h"

namespace honka::eval {

/// What a pool of workers is asked to do. All but `make` is called in the caller's thread.
struct PoolOrder {
  int workers = 1;
  WorkerLimits limits;
  std::function<RunTrial()> make;         ///< called once in each worker
  std::function<bool(TrialId)> wanted;    ///< asked before a trial is handed out
  std::function<void(TrialRecord)> take;  ///< given every trial, failed ones too, as they end
};

/// Runs every trial of the batches in worker processes. A trial that outlives its time, crashes its
/// worker or runs out of memory comes back as a record with its cause, and the rest goes on.
void run_in_workers(std::vector<TrialBatch> batches, const PoolOrder& order);

}  // namespace honka::eval
