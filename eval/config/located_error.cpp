#include "eval/config/located_error.h"

namespace honka::eval {
namespace {

/// Whether `key` is `group` or lies in it.
bool belongs(const std::string& key, const std::string& group) {
  return key == group || key.rfind(group + ".", 0) == 0;
}

}  // namespace

std::string located(const std::string& message, const ResolvedScenario& resolved) {
  const std::string lead = message.substr(0, message.find_first_of(": "));
  bool names_a_key = false;
  std::string of_group;
  for (const KeyEntry& entry : list_keys(resolved.scenario)) {
    const bool dotted = entry.key.find('.') != std::string::npos;  // "seed" may be a mere word
    const bool named = dotted && message.find(entry.key) != std::string::npos;
    const bool in_group = belongs(entry.key, lead);
    names_a_key = names_a_key || named || in_group;
    const auto origin = resolved.origins.find(entry.key);
    if (origin == resolved.origins.end() || origin->second == "default") continue;
    if (named) return origin->second + ": " + message;
    if (in_group && of_group.empty()) of_group = origin->second;
  }
  if (!names_a_key) return message;
  return (of_group.empty() ? resolved.file.string() : of_group) + ": " + message;
}

}  // namespace honka::eval
