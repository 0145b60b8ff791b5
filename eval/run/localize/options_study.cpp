#include "eval/run/localize/options_study.h"

#include <fmt/format.h>

#include <cmath>

#include "algo/localize/li2020/branch_and_bound.h"
#include "algo/types/random.h"
#include "eval/config/words.h"
#include "eval/metrics/localization.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/parallel.h"
#include "eval/run/stopwatch.h"
#include "eval/run/trial_world.h"
#include "sim/forest/forest.h"

namespace honka::eval {
namespace {

struct OptionsQuery {
  Pose2 T_world_sensor;
  std::vector<Eigen::Vector2d> stems_m;
};

OptionsQuery options_query(const Scenario& scenario, const OptionsWorld& world,
                           std::uint64_t query) {
  const OptionsStudySettings& s = scenario.options;
  OptionsQuery q;
  q.T_world_sensor = sim::draw_pose(world.forest, s.border_m, world.seed, query);
  q.stems_m =
      sim::sight(world.forest, q.T_world_sensor, s.list, world.seed, query).stems_in_sensor_m;
  return q;
}

/// A GNSS position with its 3 s.d., or a circle whose middle is half its radius off the truth.
std::optional<LocatePrior> options_prior(const OptionsCase& one, const Pose2& T_world_sensor,
                                         std::uint64_t seed, std::uint64_t query) {
  RandomStream random(seed, "options_prior", {query});
  Eigen::Vector2d place_m = T_world_sensor.translation_m;
  if (one.gnss_sigma_m > 0.0) {
    const double x = random.normal(0.0, one.gnss_sigma_m);
    const double y = random.normal(0.0, one.gnss_sigma_m);
    return LocatePrior{place_m + Eigen::Vector2d(x, y), 3.0 * one.gnss_sigma_m};
  }
  if (one.prior_radius_m <= 0.0) return std::nullopt;
  const double angle = random.uniform(-kPi, kPi);
  place_m += 0.5 * one.prior_radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  return LocatePrior{place_m, one.prior_radius_m};
}

OptionsAnswer answer_option(const Scenario& scenario, const OptionsWorld& world,
                            const OptionsCase& one, const Matcher& matcher, std::uint64_t query) {
  const OptionsQuery q = options_query(scenario, world, query);
  const auto prior = options_prior(one, q.T_world_sensor, world.seed, query);
  OptionsAnswer answer;
  const Stopwatch watch;
  const LocateResult result = matcher.locate(q.stems_m, prior);
  answer.time_ms = watch.milliseconds();
  const PoseError error = pose_error(result.T_map_local, q.T_world_sensor);
  const ProtocolSettings& p = scenario.protocol;
  answer.accepted = result.accepted();
  answer.right =
      judge(answer.accepted, error, {p.success_translation_m, p.success_rotation_deg}).right;
  answer.error_m = error.translation_m;
  answer.candidates = result.candidates;
  return answer;
}

std::vector<PoseCandidate> pose_candidates(const LocateResult& result,
                                           const std::vector<Eigen::Vector2d>& local_m,
                                           const std::vector<Eigen::Vector2d>& map_m) {
  std::vector<PoseCandidate> candidates;
  for (const StarMatch& match : result.star_matches) {
    PoseCandidate c;
    for (std::size_t j = 0; j < 6; ++j) {
      c.local_m[j] = local_m[static_cast<std::size_t>(match.pairs[j].local)];
      c.map_m[j] = map_m[static_cast<std::size_t>(match.pairs[j].map)];
    }
    c.T_map_local = {match.translation_m, wrap_to_pi(match.theta_rad)};
    candidates.push_back(c);
  }
  return candidates;
}

}  // namespace

OptionsWorld make_options_world(const Scenario& scenario, std::int64_t trial) {
  OptionsWorld world;
  world.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "options_trial",
                           {static_cast<std::uint64_t>(trial)});
  world.stand = sim::make_stand(scenario.forest, {}, world.seed);
  world.forest.box_m = world.stand.extent_m;
  world.forest.trees_m = places_of(true_stems(world.stand));
  world.forest.standing.assign(world.forest.trees_m.size(), 1);
  world.forest.in_map = world.forest.standing;
  world.forest.near = std::make_unique<KdTree2>(world.forest.trees_m);
  const MapSourceSettings& sources = scenario.map.sources;
  world.inventory_m = places_of(sim::inventory_map(world.stand, sources.inventory, world.seed));
  world.airborne_m = places_of(sim::airborne_map(world.stand, sources.airborne, world.seed));
  return world;
}

std::vector<OptionsCase> options_cases(const Scenario& scenario) {
  const OptionsStudySettings& o = scenario.options;
  std::vector<OptionsCase> cases;
  const auto add = [&](const std::string& name) -> OptionsCase& {
    cases.push_back({name, "li2020", "inventory", scenario.localize, 0.0, 0.0});
    return cases.back();
  };
  add("literal");
  add("box").settings.li2020.selection = "box";
  add("branch and bound").settings.li2020.selection = "branch_and_bound";
  for (const double r : o.local_radii_m) {
    add(fmt::format("local radius {} m", r)).settings.li2020.local_radius_m = r;
  }
  for (const double size_m : o.submap_sizes_m) {
    add(fmt::format("sub-maps of {} m", size_m)).settings.li2020.submap_size_m = size_m;
  }
  // What any matcher can be told, and mapped from.
  std::vector<std::string> methods = words_of(scenario.variants.methods);
  if (methods.empty()) methods = {"li2020"};
  for (const std::string& method : methods) {
    if (method != "li2020") add("whole map").method = method;
    for (const double r : o.prior_radii_m) {
      OptionsCase& one = add(fmt::format("prior of {} m", r));
      one.method = method;
      one.prior_radius_m = r;
    }
    OptionsCase& gnss = add(fmt::format("GNSS, s.d. {} m", o.gnss_sigma_m));
    gnss.method = method;
    gnss.gnss_sigma_m = o.gnss_sigma_m;
    OptionsCase& airborne = add("airborne map");
    airborne.method = method;
    airborne.map = "airborne";
    OptionsCase& both = add("airborne map, GNSS");
    both.method = method;
    both.map = "airborne";
    both.gnss_sigma_m = o.gnss_sigma_m;
  }
  return cases;
}

std::vector<OptionsAnswer> answer_options(const Scenario& scenario, const OptionsWorld& world,
                                          const OptionsCase& one, int threads) {
  const auto& map_m = one.map == "airborne" ? world.airborne_m : world.inventory_m;
  const auto matcher = create_matcher(one.method, map_m, one.settings);
  std::vector<OptionsAnswer> answers(static_cast<std::size_t>(scenario.options.queries));
  for_each_index(answers.size(), threads, [&](std::size_t q) {
    answers[q] = answer_option(scenario, world, one, *matcher, q);
  });
  return answers;
}

std::vector<SelectionComparison> compare_selections(const Scenario& scenario,
                                                    const OptionsWorld& world) {
  const auto matcher = create_matcher("li2020", world.inventory_m, scenario.localize);
  std::vector<SelectionComparison> all;
  for (std::uint64_t q = 0; q < static_cast<std::uint64_t>(scenario.options.queries); ++q) {
    const OptionsQuery query = options_query(scenario, world, q);
    const LocateResult result = matcher->locate(query.stems_m);
    const auto candidates = pose_candidates(result, query.stems_m, world.inventory_m);
    if (candidates.empty()) continue;
    const double vertices = 6.0 * static_cast<double>(candidates.size());
    SelectionComparison one;
    one.matches = result.matches;
    const Stopwatch of_candidates;
    one.candidates_m = select_candidate(candidates).cost_m / vertices;
    one.candidates_ms = of_candidates.milliseconds();
    const Stopwatch of_box;
    one.box_m = select_in_box(candidates).cost_m / vertices;
    one.box_ms = of_box.milliseconds();
    const Stopwatch of_bound;
    const BoundedSelection global = select_by_bound(candidates);
    one.global_ms = of_bound.milliseconds();
    one.global_m = global.best.cost_m / vertices;
    one.bound_m = global.lower_bound_m / vertices;
    one.nodes = global.nodes;
    one.certified = global.certified;
    all.push_back(one);
  }
  return all;
}

}  // namespace honka::eval
