#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "algo/types/user_error.h"
#include "eval/cli/evaluate_plots.h"
#include "eval/cli/verbs.h"
#include "eval/io/kitti.h"
#include "eval/io/text_table.h"
#include "eval/io/tum.h"
#include "eval/metrics/trajectory_alignment.h"
#include "eval/metrics/trajectory_errors.h"
#include "eval/run/trajectory_json.h"

namespace honka::eval {
namespace {

/// Beyond this a position is no place on Earth, and its square is near to what a double holds.
constexpr double kFarthest_m = 1e9;
constexpr double kMostFrames = 1e9;

bool is_kitti(const EvaluateArguments& arguments) { return arguments.format == "kitti"; }

TimedPoses read_poses(const EvaluateArguments& arguments, const std::filesystem::path& file) {
  TimedPoses result;
  if (is_kitti(arguments)) {
    for (const Pose3& pose : read_kitti(file)) {
      result.poses.push_back({static_cast<double>(result.poses.size()), pose});
    }
  } else {
    result = read_tum_trajectory(file);
  }
  for (const TimedPose& pose : result.poses) {
    if (pose.pose.translation().cwiseAbs().maxCoeff() <= kFarthest_m) continue;
    throw UserError(fmt::format("{}: the pose of time {} lies beyond 1e9 m; give metres",
                                file.string(), pose.time_s));
  }
  return result;
}

std::vector<double> times(const TimedPoses& trajectory) {
  std::vector<double> result;
  for (const TimedPose& pose : trajectory.poses) result.push_back(pose.time_s);
  return result;
}

std::string span_text(const TimedPoses& trajectory) {
  return fmt::format("{} to {} s", trajectory.poses.front().time_s, trajectory.poses.back().time_s);
}

PosePairs associate(const EvaluateArguments& arguments, const TimedPoses& truth,
                    const TimedPoses& estimate) {
  const std::string file = arguments.estimate.string();
  if (is_kitti(arguments) && truth.poses.size() != estimate.poses.size()) {
    throw UserError(
        fmt::format("{}: {} rows, but {} has {}; KITTI rows pair by their number, give "
                    "TUM rows where poses are missing",
                    file, estimate.poses.size(), arguments.truth.string(), truth.poses.size()));
  }
  PosePairs pairs{{}, truth.has_rotations, estimate.has_rotations, times(estimate)};
  for (const TimePair& pair :
       associate_times(times(truth), pairs.estimate_times_s, arguments.max_time_difference_s)) {
    const TimedPose& estimated = estimate.poses[pair.estimate];
    pairs.poses.push_back({estimated.time_s, truth.poses[pair.truth].pose, estimated.pose});
  }
  if (pairs.poses.empty()) {
    throw UserError(
        fmt::format("{}: none of its times ({}) lies within {} s of one in {} ({}); "
                    "mend the clock or raise --max-time-difference",
                    file, span_text(estimate), arguments.max_time_difference_s,
                    arguments.truth.string(), span_text(truth)));
  }
  if (pairs.poses.size() == 1) {
    throw UserError(file + ": only one pose has a true one at its time; give at least two");
  }
  return pairs;
}

[[noreturn]] void refuse_delta(const std::string& text, const std::string& why) {
  throw UserError("--delta: '" + text + "' " + why +
                  "; give a number above 0 and its unit, such as 1s, 10m or 1f");
}

RelativeSettings relative_settings(const EvaluateArguments& arguments) {
  RelativeSettings settings;
  settings.all_pairs = arguments.all_pairs;
  // KITTI rows have no times.
  const std::string text = arguments.delta.value_or(is_kitti(arguments) ? "1f" : "1s");
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), settings.delta);
  if (error != std::errc() || !std::isfinite(settings.delta) || settings.delta <= 0.0) {
    refuse_delta(text, "is no motion");
  }
  const std::string unit(end, text.data() + text.size());
  if (unit == "f") {
    settings.unit = DeltaUnit::kFrames;
    const bool whole = settings.delta == std::floor(settings.delta);
    if (!whole || settings.delta > kMostFrames) refuse_delta(text, "is no whole number of frames");
  } else if (unit == "m") {
    settings.unit = DeltaUnit::kMetres;
  } else if (unit != "s") {
    refuse_delta(text, "has no unit that is known");
  } else if (is_kitti(arguments)) {
    refuse_delta(text, "needs times, which KITTI rows have not");
  }
  return settings;
}

std::string unit_name(DeltaUnit unit) {
  return unit == DeltaUnit::kSeconds ? "s" : unit == DeltaUnit::kMetres ? "m" : "f";
}

PosePairs aligned(const EvaluateArguments& arguments, const PosePairs& pairs) {
  const auto alignment = alignment_of(arguments.align);
  if (!alignment) {
    throw UserError("--align: unknown '" + arguments.align +
                    "'; give none, origin, yaw, se2, se3 or sim3");
  }
  const AlignmentResult result = align(pairs, *alignment);
  if (result.status != AlignmentStatus::kAligned) {
    throw UserError(fmt::format("{}: --align {} is not defined: {}; give another alignment",
                                arguments.estimate.string(), arguments.align,
                                alignment_problem(result.status)));
  }
  return moved(pairs, result.T_truth_estimate);
}

void print_row(const std::string& name, const std::vector<double>& errors) {
  const auto s = trajectory_statistics(errors);
  if (!s) {
    fmt::print("{:<24} none\n", name);
    return;
  }
  fmt::print("{:<24} {:>11.6f} {:>11.6f} {:>11.6f} {:>11.6f} {:>11.6f} {:>11.6f}\n", name, s->rmse,
             s->mean, s->median, s->std, s->min, s->max);
}

std::string pairing_text(const RelativeSettings& settings, bool have_rotations) {
  const std::string unit = unit_name(settings.unit);
  return fmt::format("{} over {} {}{}", have_rotations ? "motions" : "lengths of motions",
                     exact_text(settings.delta), unit == "f" ? "frame(s)" : unit,
                     settings.unit == DeltaUnit::kSeconds || settings.all_pairs
                         ? ", from every pose"
                         : ", end to end");
}

void print_text(const nlohmann::ordered_json& json, const TrajectoryErrors& absolute,
                const TrajectoryErrors& relative, const std::string& pairing) {
  fmt::print("{} pairs of {} true and {} estimated poses, alignment {}.\n",
             json["associated"].dump(), json["reference_poses"].dump(),
             json["estimate_poses"].dump(), json["align"].get<std::string>());
  fmt::print("APE: poses; RPE: {} {}. s.d. over n.\n\n", json["rpe"]["pairs"].dump(), pairing);
  fmt::print("{:<24} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "", "rmse", "mean", "median",
             "s.d.", "min", "max");
  print_row("APE translation (m)", absolute.translation_m);
  print_row("APE rotation (deg)", absolute.rotation_deg);
  print_row("RPE translation (m)", relative.translation_m);
  print_row("RPE rotation (deg)", relative.rotation_deg);
}

nlohmann::ordered_json evaluation_json(const EvaluateArguments& arguments, const PosePairs& pairs,
                                       std::size_t true_poses, const TrajectoryErrors& absolute,
                                       const TrajectoryErrors& relative,
                                       const RelativeSettings& settings) {
  nlohmann::ordered_json json;
  json["align"] = arguments.align;
  json["associated"] = pairs.poses.size();
  json["reference_poses"] = true_poses;
  json["estimate_poses"] = pairs.estimate_times_s.size();
  json["ape"] = errors_json(absolute);
  json["rpe"] = {{"delta", settings.delta},
                 {"unit", unit_name(settings.unit)},
                 {"pairs", relative.translation_m.size()}};
  json["rpe"].update(errors_json(relative));
  return json;
}

}  // namespace

int evaluate_verb(const EvaluateArguments& arguments) {
  const double most_s = arguments.max_time_difference_s;
  if (!std::isfinite(most_s) || most_s < 0.0) {
    throw UserError("--max-time-difference: must be a finite number of seconds, such as 0.02");
  }
  const RelativeSettings settings = relative_settings(arguments);
  const TimedPoses truth = read_poses(arguments, arguments.truth);
  const TimedPoses estimate = read_poses(arguments, arguments.estimate);
  const PosePairs pairs = aligned(arguments, associate(arguments, truth, estimate));
  const TrajectoryErrors absolute = absolute_errors(pairs);
  const std::vector<Motion> chosen = motions(pairs, settings);
  const TrajectoryErrors relative = relative_errors(pairs, chosen);

  const auto json =
      evaluation_json(arguments, pairs, truth.poses.size(), absolute, relative, settings);
  const std::string pairing = pairing_text(settings, pairs.have_rotations());
  if (arguments.json) {
    fmt::print("{}\n", json.dump());
  } else {
    print_text(json, absolute, relative, pairing);
  }
  if (!arguments.plot.empty()) {
    plot_evaluation(arguments.plot,
                    {pairs, absolute, chosen, relative,
                     fmt::format("alignment {}, {} pairs", arguments.align, pairs.poses.size()),
                     pairing, !is_kitti(arguments)});
  }
  return 0;
}

}  // namespace honka::eval
