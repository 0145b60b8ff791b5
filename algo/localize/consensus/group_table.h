#pragma once

#include <cstdint>
#include <vector>

namespace honka {

class StemGrid;

/// Groups of four neighbouring stems of a map, found by their distances.
class GroupTable {
 public:
  GroupTable() = default;
};

}  // namespace honka
