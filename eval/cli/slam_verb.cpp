#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/box_counting.h"
#include "algo/slam/map_quality/clusters.h"
#include "algo/slam/slam.h"
#include "algo/types/user_error.h"
#include "eval/cli/verbs.h"
#include "eval/io/context.h"
#include "eval/io/frames_csv.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"
#include "eval/io/tum.h"
#include "eval/run/progress.h"

namespace honka::eval {
namespace {

using SlamJson = nlohmann::ordered_json;

/// Shows how far the stages have come, on the error stream.
class SlamProgress : public SlamObserver {
 public:
  explicit SlamProgress(const SlamSettings& settings) : chosen_(settings.loop.corrections) {}

  void during_stage(std::string_view stage, std::size_t done, std::size_t total) override {
    if (!bar_ || stage != stage_) start(stage, static_cast<std::int64_t>(total));
    bar_->set_total(static_cast<std::int64_t>(total));
    bar_->advance(static_cast<std::int64_t>(done) - done_);
    done_ = static_cast<std::int64_t>(done);
  }
  void after_correction(const CorrectionReport& report, const FramePoses& /*poses*/) override {
    const auto done = static_cast<std::size_t>(report.number) + 1;
    during_stage("loop", done, std::max(done, static_cast<std::size_t>(chosen_)));
  }
  void after_stage(std::string_view /*stage*/, const FramePoses& /*poses*/) override {
    bar_.reset();
  }

 private:
  void start(std::string_view stage, std::int64_t total) {
    bar_.reset();
    stage_ = stage;
    done_ = 0;
    const char* unit = stage == "rechain" ? "key frames" : stage == "loop" ? "pairs" : "rounds";
    bar_ = std::make_unique<Progress>(stage_, unit, total);
  }

  std::int64_t chosen_, done_ = 0;
  std::string stage_;
  std::unique_ptr<Progress> bar_;
};

/// A mistake in what the files hold, led back to the file that holds it.
SlamResult run_located(const SlamArguments& arguments, const std::vector<SparseFrame>& frames,
                       const std::optional<FramePoses>& chain, const SlamSettings& settings) {
  SlamProgress progress(settings);
  try {
    return run_slam(frames, chain, settings, &progress);
  } catch (const UserError& error) {
    const bool of_chain = std::string_view(error.what()).find("chain") != std::string_view::npos;
    const auto& file = of_chain && chain ? arguments.chain : arguments.frames;
    throw UserError(file.string() + ": " + error.what());
  }
}

void check_method(const std::string& method) {
  const auto& names = slam_method_names();
  if (std::find(names.begin(), names.end(), method) != names.end()) return;
  const auto nearest = did_you_mean(method, names);
  throw UserError(fmt::format("--method: no SLAM method is called \"{}\"; choose one of: {}{}",
                              method, fmt::join(names, ", "),
                              nearest ? "; did you mean " + *nearest + "?" : ""));
}

SlamJson metric_json_of(double value, const char* unit, std::int64_t n) {
  SlamJson json;
  json["value"] = std::isfinite(value) ? SlamJson(value) : SlamJson(nullptr);
  json["unit"] = unit;
  json["n"] = n;
  return json;
}

/// β, e_C with both links, and the box dimension of the map.
SlamJson quality_json(const std::vector<Eigen::Vector3d>& map_m) {
  const auto points = static_cast<std::int64_t>(map_m.size());
  const RegistrationNoise wide = registration_noise(map_m, ClusterSettings{});
  ClusterSettings half;
  half.link_m = 0.5;
  const RegistrationNoise narrow = registration_noise(map_m, half);
  SlamJson json;
  json["blur"] = metric_json_of(blur(map_m, {}), "1", points);
  json["box_dimension"] = metric_json_of(box_dimension(map_m, {}), "1", points);
  json["cluster_rmse_m"] = metric_json_of(wide.mean_rmse_m, "m", wide.clusters);
  json["cluster_rmse_pooled_m"] = metric_json_of(wide.pooled_rmse_m, "m", wide.points);
  json["cluster_rmse_link_0.5_m"] = metric_json_of(narrow.mean_rmse_m, "m", narrow.clusters);
  return json;
}

/// How many frames have each status, and which are not placed.
SlamJson status_json(const std::vector<SparseFrame>& frames, const SlamResult& result) {
  SlamJson counts = SlamJson::object(), not_placed = SlamJson::array();
  for (const FrameStatus status : {FrameStatus::kPlaced, FrameStatus::kUnverified,
                                   FrameStatus::kTooFewPoints, FrameStatus::kNotFinite}) {
    counts[std::string(frame_status_name(status))] =
        std::count(result.frames.begin(), result.frames.end(), status);
  }
  for (std::size_t l = 0; l < frames.size(); ++l) {
    if (result.frames[l] == FrameStatus::kPlaced) continue;
    not_placed.push_back(
        {{"frame", frames[l].number}, {"status", frame_status_name(result.frames[l])}});
  }
  SlamJson json;
  json["counts"] = std::move(counts);
  json["not_placed"] = std::move(not_placed);
  return json;
}

SlamJson summary_of(const SlamArguments& arguments, const std::vector<SparseFrame>& frames,
                    const SlamResult& result, const Context& context) {
  const auto map_m = map_points(frames, result.T_first_frame);
  SlamJson json;
  json["schema_version"] = kResultsSchemaVersion;
  json["context"] = context.entries();
  json["method"] = arguments.method;
  json["input"] = {{"frames_file", arguments.frames.string()},
                   {"chain", arguments.chain.empty() ? "made" : arguments.chain.string()},
                   {"frames", frames.size()},
                   {"points", map_m.size()}};
  json["metrics"] = quality_json(map_m);
  json["stems"] = result.stems.size();
  json["corrections"] = result.corrections;
  json["icp_calls"] = result.icp_calls;
  json["go_icp_calls"] = result.go_icp_calls;
  json["bad_steps"] = result.bad_steps;
  json["matches"] = SlamJson::array();
  for (const PairMatch& match : result.matches) {
    json["matches"].push_back({{"earlier", frames[match.earlier].number},
                               {"later", frames[match.later].number},
                               {"share", match.share},
                               {"error_m", match.error_m}});
  }
  json["frames"] = status_json(frames, result);
  double total_s = 0.0;
  for (const StageTime& time : result.times) {
    json["times_s"][time.stage] = time.seconds;
    total_s += time.seconds;
  }
  json["times_s"]["total"] = total_s;
  return json;
}

std::string stems_csv(const SlamResult& result) {
  std::string text = "x_m,y_m,z_m,observations,rmse_m\n";
  for (const MapStem& stem : result.stems) {
    const Eigen::Vector3d& p = stem.position_in_first_m;
    for (const double value : {p.x(), p.y(), p.z()}) text.append(exact_text(value)).append(",");
    text.append(std::to_string(stem.observations)).append(",");
    text.append(exact_text(stem.rmse_m)).append("\n");
  }
  return text;
}

std::vector<TimedPose> timed_poses(const std::vector<SparseFrame>& frames,
                                   const SlamResult& result) {
  std::vector<TimedPose> poses;
  for (std::size_t l = 0; l < frames.size(); ++l) {
    poses.push_back({static_cast<double>(frames[l].number), result.T_first_frame[l]});
  }
  return poses;
}

}  // namespace

int slam_verb(const SlamArguments& arguments) {
  check_method(arguments.method);
  OutputFolder folder(arguments.out);
  const Context context(1, 0);
  std::vector<SparseFrame> frames = read_frames_csv(arguments.frames);
  std::optional<FramePoses> chain;
  if (!arguments.chain.empty()) chain = read_chain_poses(arguments.chain, frames);

  SlamSettings settings;
  settings.method = arguments.method;
  const SlamResult result = run_located(arguments, frames, chain, settings);

  const SlamJson summary = summary_of(arguments, frames, result, context);
  write_tum(folder.path() / "trajectory.tum", timed_poses(frames, result));
  write_file_safely(folder.path() / "stems.csv", stems_csv(result));
  write_file_safely(folder.path() / "summary.json", summary.dump(2) + "\n");
  folder.commit();
  fmt::print("{}: {} frames ({} not placed), {} stems, {} corrections, blur {:.4f}, {:.2f} s\n",
             folder.final_path().string(), frames.size(), summary["frames"]["not_placed"].size(),
             result.stems.size(), result.corrections,
             summary["metrics"]["blur"]["value"].is_null()
                 ? 0.0
                 : summary["metrics"]["blur"]["value"].get<double>(),
             summary["times_s"]["total"].get<double>());
  return 0;
}

}  // namespace honka::eval
