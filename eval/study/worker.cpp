#include "eval/study/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

constexpr int kOutOfMemoryExit = 77;

double process_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  constexpr double kNanoseconds = 1e-9;
  return static_cast<double>(time.tv_sec) + kNanoseconds * static_cast<double>(time.tv_nsec);
}

std::int64_t resident_bytes() {
  long pages = 0, resident = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  const int read = std::fscanf(file, "%ld %ld", &pages, &resident);
  std::fclose(file);
  return read == 2 ? resident * ::sysconf(_SC_PAGESIZE) : 0;
}

void write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return;  // the other side has ended, which its reader notices
    done += static_cast<std::size_t>(wrote);
  }
}

TrialRecord run_recorded(const RunTrial& run, TrialId id) {
  TrialRecord record;
  record.id = id;
  const auto start = std::chrono::steady_clock::now();
  const double start_cpu_s = process_seconds();
  try {
    record.results = run(id);
  } catch (const std::bad_alloc&) {
    record.status = TrialStatus::kOutOfMemory;
    record.cause =
        "no memory left for this trial; raise study.memory_limit_mb or use fewer threads";
  } catch (const std::exception& error) {
    record.status = TrialStatus::kThrew;
    record.cause = error.what();
  }
  record.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.cpu_s = process_seconds() - start_cpu_s;
  record.resident_bytes = resident_bytes();
  return record;
}

void limit_memory(std::int64_t memory_mb) {
  if (memory_mb <= 0) return;
  constexpr rlim_t kBytes = 1000 * 1000;
  const rlim_t bytes = static_cast<rlim_t>(memory_mb) * kBytes;
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
}

/// The worker's life: a line "point trial" in, a record out, until the other side closes.
[[noreturn]] void serve(const std::function<RunTrial()>& make, int in, int out, int errors) {
  try {
    const RunTrial run = make();
    std::FILE* orders = ::fdopen(in, "r");
    TrialId id;
    while (std::fscanf(orders, "%ld %ld", &id.point, &id.trial) == 2) {
      const TrialRecord record = run_recorded(run, id);
      if (::ftruncate(errors, 0) != 0) continue;  // progress of a trial that ended is of no use
      write_all(out, to_line(record) + "\n");
      // What is left of the heap after this is not worth trusting; another worker goes on.
      if (record.status == TrialStatus::kOutOfMemory) ::_exit(kOutOfMemoryExit);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    ::_exit(1);
  }
  ::_exit(0);
}

[[noreturn]] void become_worker(const std::function<RunTrial()>& make, const WorkerLimits& limits,
                                std::array<int, 3> files, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  // A crash is to end the worker, whatever its parent does about its own.
  for (const int crash : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) std::signal(crash, SIG_DFL);
  ::dup2(files[2], STDERR_FILENO);
  // Whatever the parent has open (its journal and lock, other workers' pipes) is not the worker's.
  constexpr int kIn = 3, kOut = 4, kErrors = 5, kHigh = 64;
  std::array<int, 3> high{};
  for (std::size_t k = 0; k < high.size(); ++k) high[k] = ::fcntl(files[k], F_DUPFD, kHigh);
  ::dup2(high[0], kIn);
  ::dup2(high[1], kOut);
  ::dup2(high[2], kErrors);
  ::close_range(kErrors + 1, ~0U, 0);
  limit_memory(limits.memory_mb);
  serve(make, kIn, kOut, kErrors);
}

[[noreturn]] void no_worker(int error) {
  throw RunError(fmt::format(
      "no worker can be started: {}; give fewer --threads and the same command to go on",
      std::strerror(error)));
}

/// The last line that the process wrote to its error stream.
std::string last_line(int errors) {
  constexpr std::size_t kMost = 4096;
  const off_t size = ::lseek(errors, 0, SEEK_END);
  if (size <= 0) return "";
  const off_t begin = std::max<off_t>(0, size - static_cast<off_t>(kMost));
  std::string text(static_cast<std::size_t>(size - begin), '\0');
  if (::pread(errors, text.data(), text.size(), begin) < 0) return "";
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

}  // namespace

Worker::Worker(const std::function<RunTrial()>& make, const WorkerLimits& limits) {
  std::array<int, 2> orders{}, records{};
  if (::pipe2(orders.data(), O_CLOEXEC) != 0 || ::pipe2(records.data(), O_CLOEXEC) != 0) {
    no_worker(errno);
  }
  errors_ = ::memfd_create("honka-worker", MFD_CLOEXEC);
  ::fcntl(errors_, F_SETFL, O_APPEND);  // so that emptying it takes no place in it along
  const pid_t parent = ::getpid();
  std::fflush(nullptr);  // or the worker would write it again
  process_ = ::fork();
  if (process_ < 0) no_worker(errno);
  if (process_ == 0) become_worker(make, limits, {orders[0], records[1], errors_}, parent);
  ::close(orders[0]);
  ::close(records[1]);
  to_worker_ = orders[1];
  from_worker_ = records[0];
}

Worker::~Worker() {
  kill();
  ::close(to_worker_);
  ::close(from_worker_);
  ::close(errors_);
}

void Worker::give(TrialId id) { write_all(to_worker_, fmt::format("{} {}\n", id.point, id.trial)); }

bool Worker::read(const std::function<void(TrialRecord)>& take) {
  constexpr std::size_t kMost = 1 << 16;
  std::array<char, kMost> buffer;
  const ssize_t count = ::read(from_worker_, buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  if (count == 0) return false;
  unread_.append(buffer.data(), static_cast<std::size_t>(count));
  for (std::size_t end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n')) {
    if (auto record = from_line(std::string_view(unread_).substr(0, end))) take(std::move(*record));
    unread_.erase(0, end + 1);
  }
  return true;
}

std::string Worker::end_cause() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  std::string cause =
      WIFSIGNALED(status)
          ? fmt::format("ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)))
          : fmt::format("ended with exit code {}", WEXITSTATUS(status));
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
    cause += ", as the system does when memory runs out";
  }
  const std::string words = last_line(errors_);
  return words.empty() ? cause : cause + ": " + words;
}

void Worker::kill() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

}  // namespace honka::eval
