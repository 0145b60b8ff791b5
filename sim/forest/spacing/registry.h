#pragma once

#include <string>
#include <tuple>

#include "sim/forest/spacing/hard_core.h"
#include "sim/forest/spacing/patchy.h"
#include "sim/forest/spacing/poisson.h"
#include "sim/forest/spacing/rows.h"
#include "sim/forest/spacing/strauss.h"

namespace honka::sim {

/// Every spacing process. A new one is a file with its settings and its type's name here.
using SpacingProcesses = std::tuple<Strauss,   //
                                    HardCore,  //
                                    Poisson,   //
                                    Rows,      //
                                    Patchy>;

struct SpacingSettings {
  std::string process = "strauss";
  SpacingProcesses processes;
};
void describe(SettingsVisitor& v, SpacingSettings& s);

/// Names of the processes, in the registry's order.
[[nodiscard]] std::vector<std::string> spacing_process_names();

/// Exactly `domain.count` stems by the chosen process. UserError when they do not fit.
[[nodiscard]] Points place_stems(const SpacingSettings& settings, const SpacingDomain& domain,
                                 std::uint64_t seed);

}  // namespace honka::sim
