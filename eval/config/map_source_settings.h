#pragma once

#include "sim/forest/inventory.h"

namespace honka::eval {

/// Stem maps that no harvester run made; keys `map.inventory.*` and `map.airborne.*`.
struct MapSourceSettings {
  sim::InventorySettings inventory;
  sim::AirborneSettings airborne;
};
void describe(SettingsVisitor& v, MapSourceSettings& s);

}  // namespace honka::eval
