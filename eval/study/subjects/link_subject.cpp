#include "eval/study/subjects/link_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "algo/slam/slam.h"
#include "algo/types/user_error.h"
#include "eval/run/slam/link_trial.h"
#include "eval/study/subjects/keys_text.h"
#include "eval/study/subjects/recent.h"

namespace honka::eval {
namespace {

/// A map with fewer of the stems is none: a handful of frames is placed well, and shows nothing.
constexpr double kLeastCompleteness = 0.5;

/// Drives kept for the next points: some 10 MB each.
constexpr std::size_t kDrivesKept = 8;

/// Keys that no drive depends on: points of a study that differ in these alone share the drives.
const std::vector<std::string> kBesideDrive = {"title",  "question",  "beside", "link.",
                                               "study.", "localize.", "map.",   "variants."};

std::vector<std::string> link_methods(const Scenario& scenario) {
  const std::vector<std::string> methods = scenario.link.method_list();
  const auto& known = slam_method_names();
  for (const std::string& method : methods) {
    if (std::find(known.begin(), known.end(), method) != known.end()) continue;
    throw UserError(
        fmt::format("link.study.methods: \"{}\" is not known; honka help slam lists "
                    "all",
                    method));
  }
  if (methods.empty()) {
    throw UserError("link.study.methods is empty; write \"chain, pose_graph\"");
  }
  return methods;
}

/// A drive, and the poses that its edge sends along.
struct SentDrive {
  SlamDrive drive;
  double length_m = 0.0;
};

std::shared_ptr<const SentDrive> sent_drive(const Scenario& scenario, std::int64_t number) {
  static Recent<SentDrive> recent(kDrivesKept);
  const std::string key = fmt::format("{}\n{}", number, keys_text(scenario, kBesideDrive));
  return recent.get(key, [&]() -> std::shared_ptr<const SentDrive> {
    auto sent = std::make_shared<SentDrive>();
    sent->drive = drive_for_slam(scenario, number, 1, "");
    if (sent->drive.frames.empty()) {
      throw UserError(
          fmt::format("protocol.path_length_m = {}: the drive has no key frame; make "
                      "it longer, or slam.keyframe.distance_m smaller",
                      scenario.protocol.path_length_m));
    }
    sent->length_m = sent->drive.travelled_m.back();
    return sent;
  });
}

class LinkSubject : public StudySubject {
 public:
  explicit LinkSubject(const Scenario& scenario) : scenario_(scenario) {}

  std::vector<MethodResult> run(std::int64_t trial) override {
    enter(trial % scenario_.study.worlds);
    const LinkCase link{"study", "", 0.0, scenario_.link.radio, scenario_.link.edge};
    const LinkOutcome outcome =
        exchange_drive(sent_->drive, edge_T_first_frame_, link, link_seed(scenario_, trial));
    std::vector<MethodResult> results;
    for (const std::string& method : methods_) {
      LinkRow row{trial, link, method, "", outcome.tally, {}, {}, sent_->length_m, 0.0};
      map_over_link(sent_->drive, outcome.cloud.received(), scenario_.slam, row);
      results.push_back({method, values_of(row)});
    }
    return results;
  }

 private:
  void enter(std::int64_t number) {
    if (number_ == number) return;
    number_.reset();
    sent_ = sent_drive(scenario_, number);
    edge_T_first_frame_ = edge_poses_of(sent_->drive, scenario_);
    all_stems_ = link_floor(sent_->drive, sent_->drive.frames, scenario_.slam).stems_mapped;
    number_ = number;
  }

  /// In the order of link_measures().
  [[nodiscard]] std::vector<double> values_of(const LinkRow& row) const {
    const LinkMapQuality& map = row.quality;
    const auto stems = static_cast<double>(all_stems_);
    const double complete = stems > 0.0 ? static_cast<double>(map.stems_mapped) / stems : 0.0;
    const bool mapped =
        map.ate_m <= scenario_.protocol.success_translation_m && complete >= kLeastCompleteness;
    const auto frames = static_cast<double>(sent_->drive.frames.size());
    return {mapped ? 1.0 : 0.0,
            map.ate_m,
            map.stem_rmse_m,
            complete,
            map.blur,
            static_cast<double>(row.tally.arrived) / frames,
            row.sent_bytes_per_m(),
            row.map_s};
  }

  Scenario scenario_;
  std::vector<std::string> methods_ = link_methods(scenario_);
  std::optional<std::int64_t> number_;
  std::shared_ptr<const SentDrive> sent_;
  FramePoses edge_T_first_frame_;
  std::int64_t all_stems_ = 0;  ///< that the map of all frames at their true poses holds
};

std::vector<Measure> link_measures() {
  return {{"mapped", "", "Maps in place, with half of the stems", MeasureKind::kRate, false},
          {"ate_m", "m", "Error of the path (ATE)", MeasureKind::kError, true},
          {"stem_rmse_m", "m", "Error of the mapped stems", MeasureKind::kError, true},
          {"completeness", "", "Mapped stems, of those of all frames", MeasureKind::kValue, false},
          {"blur", "", "Blur of the map", MeasureKind::kValue, true},
          {"arrived", "", "Key frames that arrived", MeasureKind::kValue, false},
          {"sent_bytes_per_m", "B/m", "Bytes sent", MeasureKind::kValue, true},
          {"map_s", "s", "Time of mapping", MeasureKind::kTime, true}};
}

}  // namespace

StudyKind link_study_kind() {
  return {"link", "the key frames of a drive over one radio link, mapped by every SLAM method",
          link_measures(), link_methods, [](const Scenario& scenario) {
            return std::unique_ptr<StudySubject>(std::make_unique<LinkSubject>(scenario));
          }};
}

}  // namespace honka::eval
