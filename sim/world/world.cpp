#include "sim/world/world.h"

namespace honka::sim {

std::string_view part_name(Part part) {
  constexpr std::array<std::string_view, kPartCount> kNames = {
      "none",        "ground", "stem",  "branch", "dead_branch", "foliage",
      "undergrowth", "rock",   "stump", "log",    "machine",     "wall"};
  return kNames[static_cast<std::size_t>(part)];
}

}  // namespace honka::sim
