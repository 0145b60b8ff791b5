#include "eval/run/slam/overlap_experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algo/slam/view_cone.h"
#include "algo/types/random.h"
#include "eval/run/slam/figure_results.h"
#include "eval/run/slam/overlap_figures.h"

namespace honka::eval {
namespace {

constexpr std::uint64_t kOverlapPairs = 300;
constexpr int kManySamples = 400000;  // stands for the area
constexpr int kUsedSamples = 256;

/// Relative poses as they come about within a frame's reach.
std::vector<Pose2> random_relative_poses(std::uint64_t seed, const ViewCone& cone) {
  std::vector<Pose2> poses;
  for (std::uint64_t id = 0; id < kOverlapPairs; ++id) {
    RandomStream random(seed, "overlap_pose", {id});
    const double x = random.uniform(-cone.range_m, cone.range_m);
    const double y = random.uniform(-cone.range_m, cone.range_m);
    poses.push_back({{x, y}, random.uniform(-kPi, kPi)});
  }
  return poses;
}

std::vector<OverlapError> sampling_errors(const std::vector<Pose2>& poses, const ViewCone& cone) {
  const ViewOverlap exact(cone, kManySamples);
  std::vector<double> areas;
  for (const Pose2& pose : poses) areas.push_back(exact(pose));
  std::vector<OverlapError> errors;
  for (int samples = 16; samples <= 16384; samples *= 2) {
    const ViewOverlap overlap(cone, samples);
    OverlapError error{samples, 0.0, 0.0};
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const double miss = std::abs(overlap(poses[k]) - areas[k]);
      error.rms += miss * miss / static_cast<double>(poses.size());
      error.largest = std::max(error.largest, miss);
    }
    error.rms = std::sqrt(error.rms);
    errors.push_back(error);
  }
  return errors;
}

FigureResults make_overlap_figures(const RunRequest& request,
                                   const std::filesystem::path& figures) {
  const ViewCone cone;
  const Pose2 T_target_source{{22.0, 10.0}, deg_to_rad(75.0)};
  const auto seed = static_cast<std::uint64_t>(request.resolved.scenario.seed);
  const auto errors = sampling_errors(random_relative_poses(seed, cone), cone);
  const double area = view_overlap(T_target_source, cone, kManySamples);
  const double used = view_overlap(T_target_source, cone, kUsedSamples);
  const auto at_used = std::find_if(errors.begin(), errors.end(), [](const OverlapError& e) {
    return e.samples == kUsedSamples;
  });
  FigureResults results;
  results.table = "overlap";
  results.facts = {{"λ of the drawn pair, 256 samples", "", used, {}, 4},
                   {"λ of the drawn pair, 400,000 samples", "", area, {}, 4},
                   {"error of 256 samples, RMS", "", at_used->rms, {}, 4},
                   {"error of 256 samples, largest", "", at_used->largest, {}, 4}};
  results.figures = {draw_overlap_cones(figures, T_target_source, cone, area),
                     draw_overlap_errors(figures, errors)};
  results.protocol = {
      fmt::format("View cones of {:g} m and {:g}°; λ is the part of one that lies in the other, "
                  "seen from above.",
                  cone.range_m, cone.angle_deg),
      fmt::format("Errors: against {} samples, over {} poses up to {:g} m away along x and y, "
                  "turned at random.",
                  kManySamples, kOverlapPairs, cone.range_m)};
  results.rows = Table({{"samples", "", "of the sunflower", std::vector<std::int64_t>{}},
                        {"rms", "", "error of λ", std::vector<double>{}},
                        {"largest", "", "error of λ", std::vector<double>{}}});
  for (const OverlapError& e : errors) results.rows.add_row(e.samples, e.rms, e.largest);
  return results;
}

}  // namespace

RunOutcome run_overlap_experiment(const RunRequest& request) {
  return run_figure_experiment(request, make_overlap_figures);
}

}  // namespace honka::eval
