#include "eval/cli/evaluate_plots.h"

#include <fmt/format.h>

#include "eval/report/figure_trajectories.h"

namespace honka::eval {
namespace {

/// Points that a curve is drawn with.
constexpr std::size_t kMostPoints = 5000;

std::vector<Eigen::Vector2d> from_above(const PosePairs& pairs, bool truth) {
  std::vector<Eigen::Vector2d> points;
  for (const PosePair& pair : pairs.poses) {
    points.emplace_back((truth ? pair.truth : pair.estimate).translation().head<2>());
  }
  return sampled(points, kMostPoints);
}

/// Errors over the times of the poses (or motions' starts) that they belong to.
template <class TimeOf>
CurvesPanel panel(const std::string& label, const std::vector<double>& errors,
                  const TimeOf& time_of) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < errors.size(); ++i) points.emplace_back(time_of(i), errors[i]);
  return {label, {{"estimate", sampled(points, kMostPoints)}}};
}

template <class TimeOf>
CurvesFigure errors_figure(const std::string& name, const std::string& title,
                           const TrajectoryErrors& errors, const EvaluationPlots& input,
                           const TimeOf& time_of) {
  CurvesFigure figure;
  figure.name = name;
  figure.title = title;
  figure.protocol = input.protocol;
  figure.x_label = input.has_times ? "time since the first pose (s)" : "number of the pose";
  figure.panels.push_back(panel("translation (m)", errors.translation_m, time_of));
  if (!errors.rotation_deg.empty()) {
    figure.panels.push_back(panel("rotation (deg)", errors.rotation_deg, time_of));
  }
  return figure;
}

void tell(const std::filesystem::path& folder, const ReportFigure& figure) {
  if (!figure.notice.empty()) {
    fmt::print(stderr, "{}: {}\n", figure.title, figure.notice);
    return;
  }
  const auto file = folder / std::filesystem::path(figure.file).filename();
  fmt::print(stderr, "{}: {}\n", figure.title, file.string());
}

}  // namespace

void plot_evaluation(const std::filesystem::path& folder, const EvaluationPlots& input) {
  const auto& poses = input.pairs.poses;
  const double first_s = poses.front().time_s;
  TrajectoriesFigure tracks{"trajectory", "Trajectories", input.protocol, {}};
  tracks.curves.push_back({"truth", from_above(input.pairs, true)});
  tracks.curves.push_back({"estimate", from_above(input.pairs, false)});
  tell(folder, draw_trajectories(folder, tracks));
  tell(folder,
       draw_curves(folder, errors_figure("ape", "APE", input.absolute, input, [&](std::size_t i) {
                     return poses[i].time_s - first_s;
                   })));
  tell(folder, draw_curves(folder, errors_figure("rpe", "RPE " + input.motion_text, input.relative,
                                                 input, [&](std::size_t i) {
                                                   return poses[input.motions[i].from].time_s -
                                                          first_s;
                                                 })));
}

}  // namespace honka::eval
