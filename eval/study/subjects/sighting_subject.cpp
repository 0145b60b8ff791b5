#include "eval/study/subjects/sighting_subject.h"

#include <limits>
#include <optional>

#include "algo/types/angles.h"
#include "eval/run/localize/sighting_trial.h"
#include "eval/study/subjects/keys_text.h"
#include "eval/study/subjects/recent.h"

namespace honka::eval {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> sighting_methods(const Scenario& scenario) {
  return methods_of(scenario.variants.methods, scenario.localize);
}

/// Forests of points kept for the next points of a study: two of large maps, which take 100 MB
/// each.
constexpr std::size_t kPointForestsKept = 32, kLargeForestsKept = 2;
constexpr std::int64_t kLargeForest = 50000;

/// Keys of studies of lists that no forest of points hangs on.
const std::vector<std::string> kBesideSightingWorld = {"title",
                                                       "question",
                                                       "beside",
                                                       "localize.",
                                                       "variants.",
                                                       "study.",
                                                       "sighting.range_m",
                                                       "sighting.field_of_view_deg",
                                                       "sighting.most_stems",
                                                       "sighting.noise_m",
                                                       "sighting.radial_bias_m",
                                                       "sighting.missed_share",
                                                       "sighting.false_share",
                                                       "sighting.border_m"};

std::shared_ptr<const SightingWorld> sighting_world(const Scenario& scenario,
                                                    const SightingCase& one, std::int64_t number) {
  static Recent<SightingWorld> small(kPointForestsKept), large(kLargeForestsKept);
  const std::string key = std::to_string(number) + "\n" + keys_text(scenario, kBesideSightingWorld);
  return (one.map.stems < kLargeForest ? small : large).get(key, [&] {
    return std::make_shared<SightingWorld>(make_sighting_world(scenario, one, number));
  });
}

class SightingSubject : public StudySubject {
 public:
  explicit SightingSubject(const Scenario& scenario)
      : scenario_(scenario), case_(sighting_cases(scenario.sighting).front()) {}

  std::vector<MethodResult> run(std::int64_t trial) override {
    enter(trial % scenario_.study.worlds);
    std::vector<MethodResult> results;
    for (std::size_t k = 0; k < methods_.size(); ++k) {
      const SightingRow row = ask_sighting(scenario_, case_, *world_, matchers_[k], trial);
      results.push_back({methods_[k], values_of(row)});
    }
    return results;
  }

 private:
  /// Grows the forest of a world, and makes every matcher over its map.
  void enter(std::int64_t number) {
    if (number_ == number) return;
    number_.reset();
    world_ = sighting_world(scenario_, case_, number);
    matchers_.clear();
    for (const std::string& method : methods_) {
      matchers_.push_back(make_timed_matcher(method, world_->mapped->map_m, scenario_.localize));
    }
    number_ = number;
  }

  /// In the order of localization_measures().
  static std::vector<double> values_of(const SightingRow& row) {
    const bool wrong = row.result.accepted() && !row.success;
    return {row.success ? 1.0 : 0.0,
            wrong ? 1.0 : 0.0,
            row.result.accepted() ? 0.0 : 1.0,
            row.success ? row.error.translation_m : kNoNumber,
            row.success ? rad_to_deg(row.error.rotation_rad) : kNoNumber,
            row.success && row.bound ? row.bound->translation_m : kNoNumber,
            static_cast<double>(row.stems),
            row.match_ms};
  }

  Scenario scenario_;
  SightingCase case_;
  std::vector<std::string> methods_ = sighting_methods(scenario_);
  std::optional<std::int64_t> number_;
  std::shared_ptr<const SightingWorld> world_;
  std::vector<TimedMatcher> matchers_;
};

}  // namespace

std::vector<Measure> localization_measures() {
  return {
      {"success", "", "Accepted and right", MeasureKind::kRate, false},
      {"wrong", "", "Accepted and wrong", MeasureKind::kRate, true},
      {"refused", "", "Not accepted", MeasureKind::kRate, true},
      {"translation_error_m", "m", "Error of the position, successes", MeasureKind::kError, true},
      {"rotation_error_deg", "deg", "Error of the heading, successes", MeasureKind::kError, true},
      {"bound_m", "m", "Cramér–Rao bound of the position, successes", MeasureKind::kError, true},
      {"stems", "", "Stems in the list", MeasureKind::kValue, false},
      {"match_ms", "ms", "Time of matching", MeasureKind::kTime, true}};
}

StudyKind sighting_study_kind() {
  return {"sighting", "one list of stems, without rays, found in the map of a forest",
          localization_measures(), sighting_methods, [](const Scenario& scenario) {
            return std::unique_ptr<StudySubject>(std::make_unique<SightingSubject>(scenario));
          }};
}

}  // namespace honka::eval
