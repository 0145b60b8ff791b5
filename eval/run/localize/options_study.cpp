#include "eval/run/localize/options_study.h"

#include <fmt/format.h>

#include <cmath>

#include "algo/localize/li2020/branch_and_bound.h"
#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "eval/config/words.h"
#include "eval/metrics/localization.h"
#include "eval/run/localize/options_query.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/parallel.h"
#include "eval/run/stopwatch.h"
#include "eval/run/trial_world.h"
#include "sim/forest/forest.h"

namespace honka::eval {
namespace {

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

/// Between the map's vertical in the sensor's frame as it is and as it is answered.
std::optional<double> tilt_error_deg(const OptionsQuery& q, const LocateResult& result) {
  if (!q.T_map_sensor_3d || !result.T_map_local_3d) return std::nullopt;
  const Eigen::Vector3d truth = q.T_map_sensor_3d->linear().row(2);
  const Eigen::Vector3d answer = result.T_map_local_3d->linear().row(2);
  return rad_to_deg(std::atan2(truth.cross(answer).norm(), truth.dot(answer)));
}

OptionsAnswer answer_option(const Scenario& scenario, const OptionsWorld& world,
                            const OptionsCase& one, const Matcher& matcher, const OptionsQuery& q,
                            std::uint64_t query) {
  const auto prior = options_prior(one, q.T_map_sensor, world.seed, query);
  OptionsAnswer answer;
  const Stopwatch watch;
  const LocateResult result = matcher.locate(q.stems_m, prior);
  answer.time_ms = watch.milliseconds();
  const PoseError error = pose_error(result.T_map_local, q.T_map_sensor);
  const ProtocolSettings& p = scenario.protocol;
  answer.accepted = result.accepted();
  answer.right =
      judge(answer.accepted, error, {p.success_translation_m, p.success_rotation_deg}).right;
  answer.error_m = error.translation_m;
  answer.candidates = result.candidates;
  answer.tilt_error_deg = tilt_error_deg(q, result);
  return answer;
}

std::vector<PoseCandidate> pose_candidates(const LocateResult& result,
                                           const std::vector<Eigen::Vector3d>& local_m,
                                           const std::vector<Eigen::Vector3d>& map_m) {
  std::vector<PoseCandidate> candidates;
  for (const StarMatch& match : result.star_matches) {
    PoseCandidate c;
    for (std::size_t j = 0; j < 6; ++j) {
      c.local_m[j] = local_m[static_cast<std::size_t>(match.pairs[j].local)].head<2>();
      c.map_m[j] = map_m[static_cast<std::size_t>(match.pairs[j].map)].head<2>();
    }
    c.T_map_local = {match.translation_m, wrap_to_pi(match.theta_rad)};
    candidates.push_back(c);
  }
  return candidates;
}

/// The rows as they are listed.
class OptionCases {
 public:
  explicit OptionCases(const Scenario& scenario) : scenario_(scenario) {}

  OptionsCase& add(const std::string& name, const std::string& method = "li2020") {
    OptionsCase& one = cases_.emplace_back();
    one.name = name;
    one.method = method;
    one.settings = scenario_.localize;
    return one;
  }
  OptionsCase& add_on_slope(double slope_deg, const std::string& how,
                            const std::string& method = "li2020") {
    OptionsCase& one = add(fmt::format("slope of {}°{}", slope_deg, how), method);
    one.slope_deg = slope_deg;
    return one;
  }
  /// What any matcher can be told, and mapped from.
  void add_told(const std::string& method) {
    const OptionsStudySettings& o = scenario_.options;
    for (const double r : o.prior_radii_m) {
      add(fmt::format("prior of {} m", r), method).prior_radius_m = r;
    }
    add(fmt::format("GNSS, s.d. {} m", o.gnss_sigma_m), method).gnss_sigma_m = o.gnss_sigma_m;
    add("airborne map", method).map = "airborne";
    OptionsCase& both = add("airborne map, GNSS", method);
    both.map = "airborne";
    both.gnss_sigma_m = o.gnss_sigma_m;
  }
  [[nodiscard]] const std::vector<OptionsCase>& all() const { return cases_; }

 private:
  const Scenario& scenario_;
  std::vector<OptionsCase> cases_;
};

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
  OptionCases cases(scenario);
  cases.add("literal");
  cases.add("box").settings.li2020.selection = "box";
  cases.add("branch and bound").settings.li2020.selection = "branch_and_bound";
  for (const double r : scenario.options.local_radii_m) {
    cases.add(fmt::format("local radius {} m", r)).settings.li2020.local_radius_m = r;
  }
  for (const double size_m : scenario.options.submap_sizes_m) {
    cases.add(fmt::format("sub-maps of {} m", size_m)).settings.li2020.submap_size_m = size_m;
  }
  for (const double slope_deg : scenario.options.slopes_deg) {
    cases.add_on_slope(slope_deg, ", stars in the plane");
    cases.add_on_slope(slope_deg, ", stars in space").settings.li2020.stars = "space";
    cases.add_on_slope(slope_deg, ", levelled").levelled = true;
  }
  std::vector<std::string> methods = words_of(scenario.variants.methods);
  if (methods.empty()) methods = {"li2020"};
  for (const std::string& method : methods) {
    if (method != "li2020") cases.add("whole map", method);
    cases.add_told(method);
    if (method == "li2020") continue;
    for (const double slope_deg : scenario.options.slopes_deg) {
      cases.add_on_slope(slope_deg, "", method);
    }
  }
  return cases.all();
}

std::vector<OptionsAnswer> answer_options(const Scenario& scenario, const OptionsWorld& world,
                                          const OptionsCase& one, int threads) {
  const OptionsQueries queries(scenario, world, one);
  const auto matcher = create_matcher(one.method, queries.map_m(), one.settings);
  std::vector<OptionsAnswer> answers(static_cast<std::size_t>(scenario.options.queries));
  for_each_index(answers.size(), threads, [&](std::size_t q) {
    answers[q] = answer_option(scenario, world, one, *matcher, queries.query(q), q);
  });
  return answers;
}

std::vector<SelectionComparison> compare_selections(const Scenario& scenario,
                                                    const OptionsWorld& world) {
  const OptionsCase literal = options_cases(scenario).front();
  const OptionsQueries queries(scenario, world, literal);
  const auto map_m = queries.map_m();
  const auto matcher = create_matcher(literal.method, map_m, literal.settings);
  std::vector<SelectionComparison> all;
  for (std::uint64_t q = 0; q < static_cast<std::uint64_t>(scenario.options.queries); ++q) {
    const OptionsQuery query = queries.query(q);
    const LocateResult result = matcher->locate(query.stems_m);
    const auto candidates = pose_candidates(result, query.stems_m, map_m);
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
