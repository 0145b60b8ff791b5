#include "eval/io/interruption.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>

namespace honka::eval {
namespace {

constexpr int kInterrupted = 3;

struct UnfinishedPaths {
  std::mutex mutex;
  std::multiset<std::filesystem::path> paths;
  std::string advice =
      "earlier results are untouched and nothing half-written is left; give the same command to "
      "start again";
};

/// Never destroyed: the waiting thread may outlive main.
UnfinishedPaths& unfinished_paths() {
  static auto* paths = new UnfinishedPaths;
  return *paths;
}

sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

[[noreturn]] void end_now(int signal) {
  UnfinishedPaths& unfinished = unfinished_paths();
  const std::lock_guard lock(unfinished.mutex);
  std::error_code ignored;
  // Twice: another thread may still be writing while the first pass removes.
  for (int pass = 0; pass < 2; ++pass) {
    for (const auto& path : unfinished.paths) std::filesystem::remove_all(path, ignored);
  }
  std::fprintf(stderr, "\nhonka: stopped by %s; %s\n", signal == SIGINT ? "Ctrl-C" : "SIGTERM",
               unfinished.advice.c_str());
  std::fflush(stderr);
  ::_exit(kInterrupted);
}

}  // namespace

void end_cleanly_when_interrupted() {
  const sigset_t signals = ending_signals();
  // Blocked here and so in every later thread: the one that waits takes them as plain work.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    while (sigwait(&signals, &signal) != 0) continue;
    end_now(signal);
  }).detach();
}

void when_interrupted_say(const std::string& advice) {
  UnfinishedPaths& unfinished = unfinished_paths();
  const std::lock_guard lock(unfinished.mutex);
  unfinished.advice = advice;
}

Unfinished::Unfinished(std::filesystem::path path)
    : path_(std::filesystem::absolute(std::move(path))) {
  UnfinishedPaths& unfinished = unfinished_paths();
  const std::lock_guard lock(unfinished.mutex);
  unfinished.paths.insert(path_);
}

Unfinished::~Unfinished() {
  UnfinishedPaths& unfinished = unfinished_paths();
  const std::lock_guard lock(unfinished.mutex);
  unfinished.paths.extract(path_);
}

}  // namespace honka::eval
