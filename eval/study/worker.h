#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>

#include "eval/study/trial_record.h"

namespace honka::eval {

/// Runs one trial; called in a worker, which keeps what the next trial can use.
using RunTrial = std::function<std::vector<MethodResult>(TrialId)>;

/// What every worker may take.
struct WorkerLimits {
  double time_s = 600.0;       ///< a trial
  std::int64_t memory_mb = 0;  ///< 0: what the machine has
};

/// A process of its own that runs trials one at a time, so that a trial which hangs, crashes or
/// takes all memory ends this process and no other. It ends with the one that made it.
class Worker {
 public:
  /// Makes the process. `make` is called in it, once. RunError when the system has none.
  Worker(const std::function<RunTrial()>& make, const WorkerLimits& limits);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void give(TrialId id);
  /// To wait on: readable when a record is there, and when the process has ended.
  [[nodiscard]] int file() const { return from_worker_; }
  /// Reads what is there; whole records go to `take`. False when the process has ended.
  [[nodiscard]] bool read(const std::function<void(TrialRecord)>& take);
  /// Why a process that has ended did so, in words; `last_words` of its error stream go with it.
  [[nodiscard]] std::string end_cause();
  /// Ends the process at once.
  void kill();

 private:
  pid_t process_ = -1;
  int to_worker_ = -1, from_worker_ = -1, errors_ = -1;
  std::string unread_;
};

}  // namespace honka::eval
