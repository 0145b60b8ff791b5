#include "eval/run/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace honka::eval {
namespace {

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

Progress::Progress(std::string what, std::string unit, std::int64_t total)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { show(true); }

void Progress::advance(std::int64_t steps) {
  const std::lock_guard lock(advancing_);
  done_ += steps;
  const double pause_s = terminal_ ? 0.2 : 15.0;
  if (seconds_between(shown_, Clock::now()) >= pause_s) show(false);
}

void Progress::show(bool last) {
  if (what_.empty()) return;
  shown_ = Clock::now();
  const double elapsed_s = seconds_between(start_, shown_);
  const double rate = elapsed_s > 0 ? static_cast<double>(done_) / elapsed_s : 0.0;
  std::string line = fmt::format("{}: {} of {} {}", what_, done_, total_, unit_);
  if (last) {
    line += fmt::format(" in {}", duration_text(elapsed_s));
  } else if (rate > 0) {
    const double left_s = static_cast<double>(total_ - done_) / rate;
    const int decimals = rate < 9.95 ? 1 : 0;
    line +=
        fmt::format(", {:.{}f}/s, {} left", rate, decimals, duration_text(std::max(0.0, left_s)));
  }
  if (!remark_.empty()) line += "; " + remark_;
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{}{}", line, last ? "\n" : "");
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

}  // namespace honka::eval
