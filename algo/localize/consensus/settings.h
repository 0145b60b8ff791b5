#pragma once

#include "algo/types/settings.h"

namespace honka {

/// Settings of the matcher `consensus`. One set of values serves every map and
/// sensor; what is not here (noise, share of false stems, view) is estimated
/// from the stems or does not matter.
struct ConsensusSettings {
  double stem_sigma_m = 0.15;   ///< of seen against mapped stems on each axis; where searches start
  double sigma_floor_m = 0.02;  ///< least noise that an answer may claim
  double accept_nats = 14.0;    ///< evidence over chance and over the runner-up to be accepted
  double least_share = 0.5;     ///< more than this share of the local stems must have partners
  double radial_bias_sds =
      3.0;  ///< a bias along the line of sight beyond so many s.d. is taken out
  double exhaustive_votes = 4.0e7;  ///< largest turn-shift-count search; 0 is off
};

void describe(SettingsVisitor& v, ConsensusSettings& s);

}  // namespace honka
