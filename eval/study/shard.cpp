#include "eval/study/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <tuple>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

/// Trials of one world and point that go to the same shard: enough to be worth growing the world.
constexpr std::int64_t kBatch = 16;
/// Trials of a point that are run before the next ones where it may stop early.
constexpr std::int64_t kRound = 100;
constexpr std::int64_t kMostParts = 100000;

bool read_number(std::string_view text, std::int64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

Shard parse_shard(const std::string& text) {
  Shard shard;
  const std::size_t slash = text.find('/');
  const bool read = slash != std::string::npos &&
                    read_number(std::string_view(text).substr(0, slash), shard.index) &&
                    read_number(std::string_view(text).substr(slash + 1), shard.count);
  if (!read || shard.count < 1 || shard.count > kMostParts || shard.index < 0 ||
      shard.index >= shard.count) {
    throw UserError(
        fmt::format("--shard {}: write i/N with i from 0 to N - 1, for example --shard 0/7", text));
  }
  return shard;
}

std::int64_t shard_of(const Study& study, TrialId id, std::int64_t count) {
  const std::int64_t worlds = study.base.scenario.study.worlds;
  const auto places = static_cast<std::int64_t>(study.points.size()) * worlds;
  const std::int64_t batch = id.trial / worlds / kBatch;
  return (batch * places + id.point * worlds + id.trial % worlds) % count;
}

std::vector<TrialBatch> batches_of(const Study& study, const Shard& shard) {
  const StudySettings& settings = study.base.scenario.study;
  const bool may_stop = settings.stop_half_width > 0.0;
  // (point, round, world) → its trials in order
  std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, TrialBatch> batches;
  const auto points = static_cast<std::int64_t>(study.points.size());
  for (std::int64_t point = 0; point < points; ++point) {
    for (std::int64_t trial = 0; trial < study.trials; ++trial) {
      const TrialId id{point, trial};
      if (shard_of(study, id, shard.count) != shard.index) continue;
      batches[{point, may_stop ? trial / kRound : 0, trial % settings.worlds}].push_back(id);
    }
  }
  std::vector<TrialBatch> in_order;
  for (auto& [key, batch] : batches) in_order.push_back(std::move(batch));
  return in_order;
}

}  // namespace honka::eval
