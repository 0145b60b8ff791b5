#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace honka::eval {

/// Keeps the last few things that were made, by a text that says all they depend on: points of a
/// study that differ in nothing that matters to a world share it. One thread at a time.
template <class Made>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

  /// The kept one, or what `make` gives, which is kept then.
  [[nodiscard]] std::shared_ptr<const Made> get(
      const std::string& key, const std::function<std::shared_ptr<const Made>()>& make) {
    for (auto it = kept_.begin(); it != kept_.end(); ++it) {
      if (it->first != key) continue;
      auto found = std::move(*it);
      kept_.erase(it);
      kept_.push_back(std::move(found));
      return kept_.back().second;
    }
    if (kept_.size() >= most_) kept_.pop_front();  // before the next needs its memory
    kept_.emplace_back(key, make());
    return kept_.back().second;
  }

 private:
  std::size_t most_;
  std::deque<std::pair<std::string, std::shared_ptr<const Made>>> kept_;  ///< the latest last
};

}  // namespace honka::eval
