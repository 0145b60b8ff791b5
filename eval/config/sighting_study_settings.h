#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/types/settings.h"
#include "sim/sighting/settings.h"

namespace honka::eval {

/// What differs from case to case: an empty list leaves the value of the study; all others are of
/// one length, an entry a case.
struct SightingCaseLists {
  std::vector<std::int64_t> stems_in_map, most_stems, queries, li2020_queries;
  std::vector<double> noise_m, missed_share, false_share, felled_share;
};

/// Localization of stem lists without rays; keys `sighting.*`.
struct SightingStudySettings {
  sim::SightingSettings detector;
  sim::MappingSettings map;
  double border_m = 30.0;
  bool elsewhere = false;
  std::int64_t queries = 1000;
  std::int64_t li2020_queries = 1000;
  SightingCaseLists cases;
};
void describe(SettingsVisitor& v, SightingStudySettings& s);

/// One case of the study: a kind of map and of lists.
struct SightingCase {
  std::string name;  ///< what the lists say of it: "noise 0.15 m, 30 % missed"
  sim::SightingSettings detector;
  sim::MappingSettings map;
  std::int64_t queries = 0, li2020_queries = 0;
};

/// The cases in order; one, "all", where no list says anything. UserError at lists of different
/// lengths.
[[nodiscard]] std::vector<SightingCase> sighting_cases(const SightingStudySettings& settings);

/// Real pairs of a map and a list; keys `pairs.*`. Place k of each list belongs to name k.
struct StemPairSettings {
  std::string folder = "../shared/data/paired_stem_maps";
  std::string names = "rioja_01, rioja_02, rioja_03, rioja_04, rioja_05, rioja_06";
  std::vector<double> yaw_deg = {-8.48, -8.68, -8.39, -8.23, -8.54, -8.66};
  std::vector<double> x_m = {-0.04, -0.11, 0.46, 0.45, -1.23, 0.62};
  std::vector<double> y_m = {-0.32, 0.07, 0.06, 1.17, 2.01, 1.79};
  double within_m = 0.3;
  double within_deg = 1.0;
};
void describe(SettingsVisitor& v, StemPairSettings& s);

}  // namespace honka::eval
