#include "eval/study/trial_queue.h"

#include <algorithm>

namespace honka::eval {
namespace {

/// How many of `left` trials a helper takes: the later half, rounded up.
std::size_t helpers_part(std::size_t left) { return (left + 1) / 2; }

}  // namespace

TrialQueue::TrialQueue(std::vector<TrialBatch> batches, std::size_t workers)
    : batches_(std::make_move_iterator(batches.begin()), std::make_move_iterator(batches.end())),
      lanes_(workers) {}

std::optional<TrialId> TrialQueue::next(std::size_t worker) {
  Lane& lane = lanes_.at(worker);
  if (lane.left.empty() && !batches_.empty()) {
    lane = Lane{{batches_.front().begin(), batches_.front().end()}};
    batches_.pop_front();
  }
  if (lane.left.empty()) help(lane);
  if (lane.left.empty()) return std::nullopt;
  const TrialId id = lane.left.front();
  lane.left.pop_front();
  return id;
}

void TrialQueue::ended(std::size_t worker, double wall_s) {
  Lane& lane = lanes_.at(worker);
  (lane.ended++ == 0 ? lane.first_s : lane.later_s) += wall_s;
}

bool TrialQueue::worth_helping(const Lane& lane) const {
  if (lane.left.empty()) return false;
  if (lane.ended < 2) return lane.left.size() > 1;  // what a world costs is not known yet
  const double trial_s = lane.later_s / static_cast<double>(lane.ended - 1);
  const double world_s = std::max(0.0, lane.first_s - trial_s);
  return static_cast<double>(helpers_part(lane.left.size())) * trial_s > world_s;
}

void TrialQueue::help(Lane& helper) {
  const auto longest =
      std::max_element(lanes_.begin(), lanes_.end(),
                       [](const Lane& a, const Lane& b) { return a.left.size() < b.left.size(); });
  if (!worth_helping(*longest)) return;
  const std::size_t part = helpers_part(longest->left.size());
  const auto from = longest->left.end() - static_cast<std::ptrdiff_t>(part);
  helper = Lane{{from, longest->left.end()}};
  longest->left.erase(from, longest->left.end());
}

}  // namespace honka::eval
