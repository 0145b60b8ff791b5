#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "sim/forest/stand.h"
#include "sim/sighting/sight.h"

namespace honka::eval {

/// A stand, its trees as points for lists without rays, and a map of each source.
struct OptionsWorld {
  sim::Stand stand;
  sim::MappedForest forest;
  std::vector<Eigen::Vector2d> inventory_m, airborne_m;
  std::uint64_t seed = 0;
};

/// The digits depend on (scenario, trial) alone.
[[nodiscard]] OptionsWorld make_options_world(const Scenario& scenario, std::int64_t trial);

/// One way of localizing the same lists.
struct OptionsCase {
  std::string name, method;
  std::string map = "inventory";
  LocalizeSettings settings;
  double prior_radius_m = 0.0;  ///< 0: none
  double gnss_sigma_m = 0.0;    ///< above 0: the prior is a GNSS position
  /// The stand lies on a slope of this, and its sensor along the ground.
  std::optional<double> slope_deg;
  bool levelled = false;  ///< lists are turned upright by the true tilt before they are matched
};

/// The literal form first, then each option of the scenario.
[[nodiscard]] std::vector<OptionsCase> options_cases(const Scenario& scenario);

/// One answer of one case.
struct OptionsAnswer {
  bool accepted = false, right = false;
  double error_m = 0.0, time_ms = 0.0;
  /// Between the true and the answered vertical; of answers with a tilt.
  std::optional<double> tilt_error_deg;
  int candidates = 0;  ///< star pairs compared in full
};

/// Every query of a world by one case, in the order of the queries.
[[nodiscard]] std::vector<OptionsAnswer> answer_options(const Scenario& scenario,
                                                        const OptionsWorld& world,
                                                        const OptionsCase& one, int threads);

/// Li2020 Eq. (4) over the same matches by its three selections.
struct SelectionComparison {
  int matches = 0;
  double candidates_m = 0.0, box_m = 0.0, global_m = 0.0, bound_m = 0.0;  ///< cost a vertex
  std::int64_t nodes = 0;
  bool certified = false;
  double candidates_ms = 0.0, box_ms = 0.0, global_ms = 0.0;
};

/// Of every query whose literal answer has a match.
[[nodiscard]] std::vector<SelectionComparison> compare_selections(const Scenario& scenario,
                                                                  const OptionsWorld& world);

}  // namespace honka::eval
