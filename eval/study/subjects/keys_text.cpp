#include "eval/study/subjects/keys_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace honka::eval {

std::string keys_text(const Scenario& scenario, const std::vector<std::string>& without) {
  std::string text;
  for (const KeyEntry& entry : list_keys(scenario)) {
    const bool out = std::any_of(without.begin(), without.end(), [&](const std::string& start) {
      return entry.key.rfind(start, 0) == 0;
    });
    if (!out) text += fmt::format("{}={}\n", entry.key, format_value(entry.value));
  }
  if (!scenario.measured) return text;
  for (const Stem& stem : *scenario.measured) {
    text += fmt::format("{},{},{},{}\n", stem.position_m.x(), stem.position_m.y(),
                        stem.dbh_m.value_or(0.0), stem.height_m.value_or(0.0));
  }
  return text;
}

}  // namespace honka::eval
