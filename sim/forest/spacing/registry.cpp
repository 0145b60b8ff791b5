#include "sim/forest/spacing/registry.h"

#include "algo/types/check.h"
#include "algo/types/user_error.h"

namespace honka::sim {

std::vector<std::string> spacing_process_names() {
  return std::apply(
      [](const auto&... process) {
        return std::vector<std::string>{std::string(process.kName)...};
      },
      SpacingProcesses{});
}

void describe(SettingsVisitor& v, SpacingSettings& s) {
  v.field({"process", "", "how stems stand to each other",
           "real mature Scots pine is mildly regular: a soft core"},
          s.process, spacing_process_names());
  const auto one = [&](auto& process) { v.group(process.kName, [&] { describe(v, process); }); };
  std::apply([&](auto&... process) { (one(process), ...); }, s.processes);
}

Points place_stems(const SpacingSettings& settings, const SpacingDomain& domain,
                   std::uint64_t seed) {
  if (domain.count == 0) return {};
  RandomStream stream(seed, "spacing");
  Points placed;
  bool known = false;
  const auto one = [&](const auto& process) {
    if (settings.process != process.kName) return;
    known = true;
    placed = process.place(domain, stream);
  };
  std::apply([&](const auto&... process) { (one(process), ...); }, settings.processes);
  if (!known) throw UserError("forest.spacing.process: no process '" + settings.process + "'");
  HONKA_CHECK(static_cast<std::int64_t>(placed.size()) == domain.count, "every stem is placed");
  return placed;
}

}  // namespace honka::sim
