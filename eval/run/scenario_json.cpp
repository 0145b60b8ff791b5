#include "eval/run/scenario_json.h"

namespace honka::eval {

Json resolved_keys(const Scenario& scenario) {
  Json json = Json::object();
  for (const KeyEntry& entry : list_keys(scenario)) {
    std::visit([&](const auto& value) { json[entry.key] = value; }, entry.value);
  }
  return json;
}

}  // namespace honka::eval
