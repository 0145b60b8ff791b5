#pragma once

#include <cstdint>
#include <string>

#include "algo/types/settings.h"

namespace honka {

/// Settings of the literal matcher; each reading of what the paper leaves open is one of them.
struct Li2020Settings {
  double tolerance_m2 = 4.5;             ///< of the star's centre and of each neighbour
  std::int64_t neighbours_required = 3;  ///< of the three neighbours, how many must pass
  std::string pairing = "similar_edge";  ///< similar_edge | least_side_sum
  double vertex_gate_m = 0.0;            ///< geometric verification; 0 is off
  std::string selection = "candidates";  ///< candidates | box | branch_and_bound
  double agreement_m = 1.0;              ///< mean residual below which a match agrees
  std::int64_t min_agreeing = 3;         ///< agreeing matches that make a success
  double local_radius_m = 0.0;           ///< only local stems this near; 0 is all
  double submap_size_m = 0.0;            ///< side of a tile of the map; 0 is the map as one
  double submap_overlap_m = 60.0;        ///< that neighbouring tiles share
  std::string stars = "plane";           ///< plane | space
};

void describe(SettingsVisitor& v, Li2020Settings& s);

}  // namespace honka
