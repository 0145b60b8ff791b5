#pragma once

#include <string>

#include "algo/types/settings.h"

namespace honka::eval {

/// The stands of the odometry experiment; keys `stands.*`. Each is the scenario's own forest but
/// for the keys of its group.
struct StandsSettings {
  struct Plain {
    bool run = true;
  } plain;
  struct Open {
    bool run = true;
    double density_per_ha = 100.0;
  } open;
  struct Dense {
    bool run = true;
    double density_per_ha = 800.0;
  } dense;
  struct Thinned {
    bool run = true;
    double left_per_ha = 156.0;
  } thinned;
  struct Undergrowth {
    bool run = true;
    double bushes_per_ha = 1500.0;
    double saplings_per_ha = 1500.0;
  } undergrowth_rich;
  struct Steep {
    bool run = true;
    double slope_deg = 18.0;
  } steep;
  std::string odometries = "all";  ///< or the name of one
  double path_length_m = 110.0;    ///< of the drive; of the plain stand protocol.path_length_m
};
void describe(SettingsVisitor& v, StandsSettings& s);

}  // namespace honka::eval
