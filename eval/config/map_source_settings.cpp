#include "eval/config/map_source_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, MapSourceSettings& s) {
  v.group("inventory", [&] { describe(v, s.inventory); });
  v.group("airborne", [&] { describe(v, s.airborne); });
}

}  // namespace honka::eval
