#include "eval/run/localize/timed_matcher.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "algo/localize/consensus/consensus.h"
#include "algo/types/user_error.h"
#include "eval/config/words.h"
#include "eval/run/localize/peak_memory.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {

TimedMatcher make_timed_matcher(const std::string& method,
                                const std::vector<Eigen::Vector2d>& stems_in_map_m,
                                const LocalizeSettings& settings) {
  TimedMatcher timed;
  const MemoryMeter memory;
  const Stopwatch watch;
  std::shared_ptr<const ConsensusIndex> index;
  try {
    if (method == "consensus") {
      index = std::make_shared<const ConsensusIndex>(stems_in_map_m);
      timed.matcher = std::make_unique<ConsensusMatcher>(index, settings.consensus);
    } else {
      timed.matcher = create_matcher(method, stems_in_map_m, settings);
    }
  } catch (const UserError&) {
    // A map that cannot be matched in is a result: its rows say so.
  }
  timed.build_ms = watch.milliseconds();
  timed.memory_bytes = memory.peak_bytes();
  if (index) timed.index_bytes = static_cast<std::int64_t>(index->to_bytes().size());
  return timed;
}

std::vector<std::string> methods_of(const std::string& methods, const LocalizeSettings& settings) {
  std::vector<std::string> words = words_of(methods);
  if (words.empty()) words = {settings.method};
  const std::vector<std::string>& known = matcher_names();
  for (const std::string& word : words) {
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    throw UserError(fmt::format("variants.methods: no matcher \"{}\"; there are {}", word,
                                fmt::join(known, ", ")));
  }
  return words;
}

}  // namespace honka::eval
