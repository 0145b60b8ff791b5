#include "algo/slam/slam.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "algo/slam/slam_stages.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

/// A part of the way from frames to a map.
struct SlamStage {
  std::string_view name;
  void (*run)(SlamWork&) = nullptr;
};

constexpr SlamStage kRechain{"rechain", stage_rechain};
constexpr SlamStage kPaperLoop{"loop", stage_paper_loop};
constexpr SlamStage kPairs{"pairs", stage_pairs};
constexpr SlamStage kInterpolate{"interpolate", stage_interpolate};
constexpr SlamStage kPoseGraph{"pose_graph", stage_pose_graph};
constexpr SlamStage kLandmarkBa{"landmark_ba", stage_landmark_ba};

struct SlamMethod {
  std::string_view name;
  bool rechained;                   ///< where `start` is by_method
  std::array<SlamStage, 3> stages;  ///< after the start; those without a name are none
};

// One line for each method.
constexpr std::array kSlamMethods = {
    SlamMethod{"chain", false, {}},
    SlamMethod{"paper", false, {kPaperLoop}},
    SlamMethod{"interpolate", true, {kPairs, kInterpolate}},
    SlamMethod{"pose_graph", true, {kPairs, kPoseGraph}},
    SlamMethod{"landmark_ba", true, {kPairs, kPoseGraph, kLandmarkBa}},
};

const std::vector<std::string>& slam_starts() {
  static const std::vector<std::string> names = {"by_method", "chain", "rechained"};
  return names;
}

const SlamMethod& find_slam_method(const std::string& name) {
  const auto* found = std::find_if(kSlamMethods.begin(), kSlamMethods.end(),
                                   [&](const SlamMethod& m) { return m.name == name; });
  if (found == kSlamMethods.end()) {
    throw UserError(fmt::format("no SLAM method is called \"{}\"; choose one of: {}", name,
                                fmt::join(slam_method_names(), ", ")));
  }
  return *found;
}

bool starts_rechained(const SlamMethod& method, const std::string& start) {
  const auto& names = slam_starts();
  if (std::find(names.begin(), names.end(), start) == names.end()) {
    throw UserError(fmt::format("no SLAM start is called \"{}\"; choose one of: {}", start,
                                fmt::join(names, ", ")));
  }
  return start == "rechained" || (start == "by_method" && method.rechained);
}

void check_numbers(std::span<const SparseFrame> frames) {
  if (frames.empty()) throw UserError("no frames; a map needs at least one");
  const auto falls = std::adjacent_find(
      frames.begin(), frames.end(),
      [](const SparseFrame& a, const SparseFrame& b) { return a.number >= b.number; });
  if (falls != frames.end()) {
    throw UserError(fmt::format("frame {} comes after frame {}; numbers of frames must rise",
                                std::next(falls)->number, falls->number));
  }
}

template <class Stage>
void timed_stage(SlamWork& work, std::string_view name, Stage run) {
  const auto start = std::chrono::steady_clock::now();
  run(work);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  work.result.times.push_back({std::string(name), taken.count()});
  if (work.observer != nullptr) work.observer->after_stage(name, work.poses);
}

}  // namespace

void describe(SettingsVisitor& v, SlamKeyFrameSettings& s) {
  v.field({"distance_m", "m", "the edge sends a frame this far from the last one sent",
           "choice: gives the number of frames of Nevalainen2021 §3"},
          s.distance_m, Range{0.01, 100.0});
  v.field({"angle_deg", "deg", "or turned by this", "choice: as above"}, s.angle_deg,
          Range{0.1, 180.0});
}

void describe(SettingsVisitor& v, SlamSettings& s) {
  v.field({"method", "", "how frames become a map", "Nevalainen2021: paper; the others beyond it"},
          s.method, slam_method_names());
  v.field({"start", "", "from the edge's chain as it is, or re-registered; or as the method needs",
           "choice: chain and paper take it as it is"},
          s.start, slam_starts());
  v.group("keyframe", [&] { describe(v, s.keyframe); });
  v.group("view", [&] { describe(v, s.view); });
  v.group("match", [&] { describe(v, s.match); });
  v.group("chain", [&] { describe(v, s.chain); });
  v.group("loop", [&] { describe(v, s.loop); });
  v.group("rechain", [&] { describe(v, s.rechain); });
  v.group("pairs", [&] { describe(v, s.pairs); });
  v.group("interpolate", [&] { describe(v, s.interpolate); });
  v.group("pose_graph", [&] { describe(v, s.pose_graph); });
  v.group("stem_map", [&] { describe(v, s.stem_map); });
  v.group("landmark_ba", [&] { describe(v, s.landmark_ba); });
}

std::string_view frame_status_name(FrameStatus status) {
  constexpr std::array<std::string_view, 4> kNames = {"placed", "unverified", "too_few_points",
                                                      "not_finite"};
  return kNames.at(static_cast<std::size_t>(status));
}

const std::vector<std::string>& slam_method_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const SlamMethod& method : kSlamMethods) list.emplace_back(method.name);
    return list;
  }();
  return names;
}

SlamResult run_slam(std::span<const SparseFrame> frames,
                    const std::optional<FramePoses>& T_first_frame_chain,
                    const SlamSettings& settings, SlamObserver* observer, std::uint64_t seed) {
  const SlamMethod& method = find_slam_method(settings.method);
  const bool rechained = starts_rechained(method, settings.start);
  check_numbers(frames);
  SlamWork work{.frames = {}, .settings = settings, .observer = observer, .seed = seed};
  work.frames = clean_frames(frames, work.result.frames);

  timed_stage(work, "chain", [&](SlamWork& w) { stage_chain(w, T_first_frame_chain); });
  if (rechained) timed_stage(work, kRechain.name, kRechain.run);
  for (const SlamStage& stage : method.stages) {
    if (stage.run != nullptr) timed_stage(work, stage.name, stage.run);
  }
  timed_stage(work, "map", stage_finish);

  work.result.T_first_frame = std::move(work.poses);
  return std::move(work.result);
}

}  // namespace honka
