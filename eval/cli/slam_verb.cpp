#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "algo/slam/slam.h"
#include "algo/types/user_error.h"
#include "eval/cli/slam_output.h"
#include "eval/cli/verbs.h"
#include "eval/io/context.h"
#include "eval/io/frames_csv.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"
#include "eval/run/progress.h"

namespace honka::eval {
namespace {

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
  json["metrics"] = map_quality_json(map_m);
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
  json["frames"] = frame_status_json(frames, result.frames);
  double total_s = 0.0;
  for (const StageTime& time : result.times) {
    json["times_s"][time.stage] = time.seconds;
    total_s += time.seconds;
  }
  json["times_s"]["total"] = total_s;
  return json;
}

}  // namespace

int slam_verb(const SlamArguments& arguments) {
  check_method(arguments.method);
  if (!arguments.vehicles.empty()) return slam_fleet(arguments);
  OutputFolder folder(arguments.out);
  const Context context(1, 0);
  std::vector<SparseFrame> frames = read_frames_csv(arguments.frames);
  std::optional<FramePoses> chain;
  if (!arguments.chain.empty()) chain = read_chain_poses(arguments.chain, frames);

  SlamSettings settings;
  settings.method = arguments.method;
  settings.pairs.propose = arguments.propose;
  const SlamResult result = run_located(arguments, frames, chain, settings);

  const SlamJson summary = summary_of(arguments, frames, result, context);
  write_tum(folder.path() / "trajectory.tum", frame_poses_in_time(frames, result.T_first_frame));
  write_file_safely(folder.path() / "stems.csv", map_stems_csv(result.stems));
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
