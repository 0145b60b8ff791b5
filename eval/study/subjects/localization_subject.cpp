#include "eval/study/subjects/localization_subject.h"

#include <limits>
#include <optional>
#include <string>

#include "algo/types/angles.h"
#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/run/drawn_window.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/mapped_run.h"
#include "eval/run/stopwatch.h"
#include "eval/run/trunk_map.h"
#include "eval/run/windows.h"
#include "eval/study/subjects/keys_text.h"
#include "eval/study/subjects/recent.h"
#include "eval/study/subjects/sighting_subject.h"

namespace honka::eval {
namespace {

constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> window_methods(const Scenario& scenario) {
  return methods_of(scenario.variants.methods, scenario.localize);
}

/// Every method by the chain that the scenario's `stems` say, and nothing beside.
Scenario one_chain(Scenario scenario) {
  scenario.localize.method = window_methods(scenario).front();
  scenario.variants.same_run = false;
  scenario.variants.repaired = false;
  scenario.variants.tolerances_m2.clear();
  return scenario;
}

/// Forests kept for the next points.
constexpr std::size_t kWorldsKept = 4;

/// Keys of studies of windows that no forest hangs on: points that differ in these alone share the
/// forests and their scenes. And that no map hangs on.
const std::vector<std::string> kBesideForest = {"title",
                                                "question",
                                                "beside",
                                                "localize.",
                                                "variants.",
                                                "study.",
                                                "protocol.window_frames",
                                                "stems.",
                                                "harvester.",
                                                "odometry.",
                                                "frame.",
                                                "map.source",
                                                "map.inventory.",
                                                "map.airborne."};
const std::vector<std::string> kBesideMap = {
    "title",  "question",  "beside", "localize.", "variants.", "study.", "protocol.window_frames",
    "stems.", "harvester."};

std::string key_of(std::int64_t number, const Scenario& scenario,
                   const std::vector<std::string>& without) {
  return std::to_string(number) + "\n" + keys_text(scenario, without);
}

/// A forest and its true stems.
struct StudyForest {
  TrialWorld world;
  StemMap stems;
};

std::shared_ptr<const StudyForest> study_forest(const Scenario& scenario, std::int64_t number) {
  static Recent<StudyForest> recent(kWorldsKept);
  return recent.get(key_of(number, scenario, kBesideForest), [&] {
    auto forest = std::make_shared<StudyForest>();
    forest->world = make_trial_world(scenario, number);
    forest->stems = true_stems(forest->world.stand);
    return forest;
  });
}

std::shared_ptr<const TrunkMap> study_map(const Scenario& scenario, std::int64_t number,
                                          const TrialWorld& world) {
  static Recent<TrunkMap> recent(kWorldsKept);
  return recent.get(key_of(number, scenario, kBesideMap), [&] {
    MappedRun run;
    if (!lists_trees(scenario.map.source)) {
      run = map_run(prior_drive(scenario, world), scenario, world.seed, "", 1, false);
    }
    return std::make_shared<TrunkMap>(
        trunk_map_of(scenario.map.source, run, stems_of_thinned_cloud(scenario), scenario, world));
  });
}

/// A forest with its map, and every method over it.
struct ForestWithMap {
  std::shared_ptr<const StudyForest> forest;
  std::vector<TrunkMap> maps;
  std::vector<Variant> variants;  ///< in the order of the methods; they point into `maps`
};

std::unique_ptr<ForestWithMap> forest_with_map(const Scenario& scenario, std::int64_t number) {
  auto mapped = std::make_unique<ForestWithMap>();
  mapped->forest = study_forest(scenario, number);
  mapped->maps.push_back(*study_map(scenario, number, mapped->forest->world));
  mapped->variants = make_variants(scenario, mapped->maps);
  return mapped;
}

class LocalizationSubject : public StudySubject {
 public:
  explicit LocalizationSubject(const Scenario& scenario)
      : scenario_(one_chain(scenario)),
        frames_(scenario.protocol.window_frames > 0 ? scenario.protocol.window_frames
                                                    : scenario.protocol.frames.back()) {
    if (scenario.map.source != "same_run") return;
    throw UserError(
        "map.source = \"same_run\": a study localizes windows of no run; it takes prior_run, "
        "inventory or airborne");
  }

  std::vector<MethodResult> run(std::int64_t trial) override {
    enter(trial % scenario_.study.worlds);
    const TrialWorld& world = mapped_->forest->world;
    const Stopwatch watch;
    DrawnWindow drawn = draw_window(scenario_, world, frames_, trial);
    const double cast_ms = watch.milliseconds();
    if (drawn.scans.size() < static_cast<std::size_t>(frames_)) return lost(cast_ms);
    const ScannedRun scanned{&drawn.drive, &world.lidar->model(), std::move(drawn.scans)};
    const Window window{trial, static_cast<std::size_t>(frames_) - 1, {frames_}};
    const auto rows = localize_window(window, scanned, mapped_->variants, scenario_,
                                      {&mapped_->forest->stems, trial});
    HONKA_CHECK(rows.size() == methods_.size(), "one row a method");
    std::vector<MethodResult> results;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      results.push_back({methods_[k], values_of(rows[k], cast_ms)});
    }
    return results;
  }

 private:
  void enter(std::int64_t number) {
    if (number_ == number) return;
    number_.reset();
    mapped_ = forest_with_map(scenario_, number);
    number_ = number;
  }

  /// A lidar odometry that lost its way before the window was complete leaves nothing to localize.
  [[nodiscard]] std::vector<MethodResult> lost(double cast_ms) const {
    std::vector<MethodResult> results;
    for (const std::string& method : methods_) {
      results.push_back({method, values_of(LocalizationRow(), cast_ms)});
    }
    return results;
  }

  /// In the order of the kind's measures.
  static std::vector<double> values_of(const LocalizationRow& row, double cast_ms) {
    const auto if_success = [&](double value) { return row.success ? value : kNoError; };
    return {row.success ? 1.0 : 0.0,
            row.accepted && !row.success ? 1.0 : 0.0,
            row.accepted ? 0.0 : 1.0,
            if_success(row.translation_error_m),
            if_success(rad_to_deg(row.rotation_error_rad)),
            if_success(row.bound_m.value_or(kNoError)),
            static_cast<double>(row.stems),
            row.match_ms,
            row.stem_rmse_m.value_or(kNoError),
            cast_ms,
            row.aggregate_ms + row.extract_ms};
  }

  Scenario scenario_;
  std::int64_t frames_;
  std::vector<std::string> methods_ = window_methods(scenario_);
  std::optional<std::int64_t> number_;
  std::unique_ptr<ForestWithMap> mapped_;
};

std::vector<Measure> window_measures() {
  std::vector<Measure> measures = localization_measures();
  measures.push_back({"stem_rmse_m", "m", "Error of the found stems", MeasureKind::kError, true});
  measures.push_back({"cast_ms", "ms", "Time of driving and casting", MeasureKind::kTime, true});
  measures.push_back({"stems_ms", "ms", "Time of finding the stems", MeasureKind::kTime, true});
  return measures;
}

}  // namespace

StudyKind localization_study_kind() {
  return {"localization", "one window of key frames, rays included, found in the map of a forest",
          window_measures(), window_methods, [](const Scenario& scenario) {
            return std::unique_ptr<StudySubject>(std::make_unique<LocalizationSubject>(scenario));
          }};
}

}  // namespace honka::eval
