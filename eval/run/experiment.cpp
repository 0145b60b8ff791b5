#include "eval/run/experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algo/types/user_error.h"
#include "eval/run/localization_experiment.h"
#include "eval/run/localize/map_update_experiment.h"
#include "eval/run/localize/options_experiment.h"
#include "eval/run/localize/sighting_experiment.h"
#include "eval/run/localize/stem_pairs_experiment.h"
#include "eval/run/localize/tracking_experiment.h"
#include "eval/run/odometry_experiment.h"
#include "eval/run/slam/calls_experiment.h"
#include "eval/run/slam/convergence_experiment.h"
#include "eval/run/slam/granularity_experiment.h"
#include "eval/run/slam/link_experiment.h"
#include "eval/run/slam/overlap_experiment.h"
#include "eval/run/slam/power_experiment.h"
#include "eval/run/slam/progress_experiment.h"
#include "eval/run/slam/selection_experiment.h"
#include "eval/run/slam/slam_experiment.h"
#include "eval/run/slam/view_experiment.h"

namespace honka::eval {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> kExperiments = {
      {"localization", "Li et al. 2020, Table 1: windows of key frames found in a trunk map",
       run_localization_experiment},
      {"sighting", "Stem lists without rays, found in maps of any size by every matcher",
       run_sighting_experiment},
      {"stem_pairs", "Real field maps against one terrestrial scan, and every wrong combination",
       run_stem_pairs_experiment},
      {"tracking", "A pose at every scan: odometry and localizations, kidnapping, loss",
       run_tracking_experiment},
      {"options", "The future work of Li et al. 2020 as options beside the literal matcher",
       run_options_experiment},
      {"map_update", "A stand thinned since it was mapped: localization while the map is updated",
       run_map_update_experiment},
      {"odometry", "Drift, speed and failures of the lidar odometries, stand by stand",
       run_odometry_experiment},
      {"link", "Edge and cloud apart: map quality by bandwidth, loss and delay",
       run_link_experiment},
      {"slam", "Nevalainen et al. 2021 on drives: starts, orders and methods of SLAM",
       run_slam_experiment},
      {"slam_selection", "Nevalainen et al. 2021, Figures 9 and 10: pairs found and chosen",
       run_selection_experiment},
      {"slam_progress",
       "Nevalainen et al. 2021: the loop, correction by correction, and its claims",
       run_progress_experiment},
      {"slam_view", "Nevalainen et al. 2021, Figure 1: a view, and neighbours' distance by range",
       run_view_experiment},
      {"slam_powers", "Nevalainen et al. 2021, Figures 2 and 3: powers of rigid transforms",
       run_power_experiment},
      {"slam_convergence", "Nevalainen et al. 2021, Figure 6: ICP by how far off it starts",
       run_convergence_experiment},
      {"slam_tilt", "Nevalainen et al. 2021, Figure 7: ICP over the tilt of its start",
       run_tilt_experiment},
      {"slam_calls", "Nevalainen et al. 2021, Table 2: calls of ICP and Go-ICP, and their time",
       run_calls_experiment},
      {"slam_granularity", "Nevalainen et al. 2021, Table 3: the leaves of Go-ICP, nodes and time",
       run_granularity_experiment},
      {"slam_overlap", "Nevalainen et al. 2021, Figure 8: the overlap of two view cones",
       run_overlap_experiment},
  };
  return kExperiments;
}

const Experiment& find_experiment(const ResolvedScenario& resolved) {
  const std::string& name = resolved.scenario.experiment;
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    names.push_back(experiment.name);
  }
  const auto origin = resolved.origins.find("experiment");
  const std::string near = nearest_word(name, names);
  throw UserError(fmt::format(
      "{}: experiment = \"{}\" is not known{}; it may be {}",
      origin == resolved.origins.end() ? resolved.file.string() : origin->second, name,
      near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near), fmt::join(names, ", ")));
}

TrialRange trials_of(const RunRequest& request) {
  const std::int64_t trials = request.resolved.scenario.trials;
  const std::int64_t first = request.trial.value_or(0);
  if (first >= trials) {
    throw UserError(fmt::format("--trial {}: {} has the trials 0 to {}", first,
                                request.resolved.file.string(), trials - 1));
  }
  return {first, request.trial ? first + 1 : trials};
}

}  // namespace honka::eval
