#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace honka::eval {

/// Tells how far long work has come, with rate and time left: a moving line on a terminal, a plain
/// line now and then elsewhere. Written to the error stream; of work without a name nothing is.
/// `advance` may be called from several threads.
class Progress {
 public:
  Progress(std::string what, std::string unit, std::int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::int64_t steps = 1);
  /// What stands at the end of the next lines, "±1.2 %".
  void remark(std::string text) { remark_ = std::move(text); }
  /// Work that turned out to be more or less than first thought.
  void set_total(std::int64_t total) { total_ = total; }

 private:
  using Clock = std::chrono::steady_clock;
  void show(bool last);

  std::mutex advancing_;
  std::string what_, unit_, remark_;
  std::int64_t total_, done_ = 0;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

/// "1 h 05 min", "3 min 20 s", "12 s".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace honka::eval
