#include "eval/study/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "eval/study/trial_queue.h"

namespace honka::eval {
namespace {

using Clock = std::chrono::steady_clock;

/// A worker's place, and the trial it is at.
struct Seat {
  std::unique_ptr<Worker> worker;
  std::optional<TrialId> trial;
  std::optional<Clock::time_point> start;  ///< once the worker has the trial
  bool spent = false;                      ///< the worker ends after what it sent

  [[nodiscard]] double seconds() const {
    return start ? std::chrono::duration<double>(Clock::now() - *start).count() : 0.0;
  }
};

class Pool {
 public:
  Pool(std::vector<TrialBatch> batches, const PoolOrder& order)
      : order_(order),
        queue_(std::move(batches), static_cast<std::size_t>(order.workers)),
        seats_(static_cast<std::size_t>(order.workers)) {}

  void run() {
    while (feed_idle()) {
      for (const std::size_t seat : wait()) {
        listen(seat);
      }
      end_the_late();
    }
  }

 private:
  /// True while any trial is under way.
  bool feed_idle() {
    bool busy = false;
    for (std::size_t k = 0; k < seats_.size(); ++k) {
      Seat& seat = seats_[k];
      if (!seat.trial) seat.trial = next_wanted(k);
      busy = busy || seat.trial;
      if (!seat.trial || seat.start) continue;
      if (!seat.worker) seat.worker = std::make_unique<Worker>(order_.make, order_.limits);
      seat.start = Clock::now();
      seat.worker->give(*seat.trial);
    }
    return busy;
  }

  void listen(std::size_t place) {
    Seat& seat = seats_[place];
    if (!seat.worker->read([&](TrialRecord record) { take(place, std::move(record)); })) {
      fail(place, TrialStatus::kCrashed, seat.worker->end_cause());
      seat.spent = true;
    }
    if (seat.spent) seat.worker.reset();
    seat.spent = false;
  }

  std::optional<TrialId> next_wanted(std::size_t seat) {
    std::optional<TrialId> id = queue_.next(seat);
    while (id && !order_.wanted(*id)) id = queue_.next(seat);
    return id;
  }

  /// Seats with news, once there are any or a trial is due to be ended.
  std::vector<std::size_t> wait() {
    std::vector<pollfd> files;
    std::vector<std::size_t> seats;
    double left_s = order_.limits.time_s;
    for (std::size_t k = 0; k < seats_.size(); ++k) {
      if (!seats_[k].trial) continue;
      files.push_back({seats_[k].worker->file(), POLLIN, 0});
      seats.push_back(k);
      left_s = std::min(left_s, order_.limits.time_s - seats_[k].seconds());
    }
    constexpr double kMilliseconds = 1000.0, kMostMilliseconds = 1e6;
    const double pause = std::clamp(std::ceil(kMilliseconds * left_s), 0.0, kMostMilliseconds);
    if (::poll(files.data(), files.size(), static_cast<int>(pause)) <= 0) return {};
    std::vector<std::size_t> ready;
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (files[k].revents != 0) ready.push_back(seats[k]);
    }
    return ready;
  }

  void end_the_late() {
    for (std::size_t k = 0; k < seats_.size(); ++k) {
      if (!seats_[k].trial || seats_[k].seconds() < order_.limits.time_s) continue;
      seats_[k].worker.reset();
      fail(k, TrialStatus::kTimedOut,
           fmt::format("took longer than {} s (study.time_limit_s)", order_.limits.time_s));
    }
  }

  void take(std::size_t seat, TrialRecord record) {
    queue_.ended(seat, record.wall_s);
    seats_[seat].trial.reset();
    seats_[seat].start.reset();
    seats_[seat].spent = record.status == TrialStatus::kOutOfMemory;
    order_.take(std::move(record));
  }

  void fail(std::size_t seat, TrialStatus status, std::string cause) {
    if (!seats_[seat].trial) return;  // it ended between two trials
    TrialRecord record;
    record.id = *seats_[seat].trial;
    record.status = status;
    record.cause = std::move(cause);
    record.wall_s = seats_[seat].seconds();
    take(seat, std::move(record));
  }

  const PoolOrder& order_;
  TrialQueue queue_;
  std::vector<Seat> seats_;
};

}  // namespace

void run_in_workers(std::vector<TrialBatch> batches, const PoolOrder& order) {
  // A worker that has just ended is told by what it leaves unread, not by a signal to us.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  Pool(std::move(batches), order).run();
  std::signal(SIGPIPE, before);
}

}  // namespace honka::eval
