#include "tests/eval/study/hand_study.h"

#include <limits>

namespace honka::test {
namespace {

std::vector<std::string> hand_methods(const eval::Scenario&) { return {"plain", "robust"}; }

const eval::StudyKind& hand_kind() {
  using eval::MeasureKind;
  static const eval::StudyKind kKind = {
      "sighting",
      "made by hand",
      {{"success", "", "Accepted and right", MeasureKind::kRate, false},
       {"wrong", "", "Accepted and wrong", MeasureKind::kRate, true},
       {"translation_error_m", "m", "Error of the position", MeasureKind::kError, true},
       {"bound_m", "m", "Bound of the position", MeasureKind::kError, true},
       {"stems", "", "Stems in the list", MeasureKind::kValue, false},
       {"match_ms", "ms", "Time of matching", MeasureKind::kTime, true}},
      hand_methods,
      nullptr};
  return kKind;
}

eval::MethodResult hand_result(const std::string& method, const HandAnswer& answer) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const bool success = answer.success == 1.0;
  return {method,
          {answer.success, answer.wrong, success ? answer.error_m : kMissing,
           success ? answer.bound_m : kMissing, answer.stems, answer.match_ms}};
}

}  // namespace

eval::Study hand_study(std::vector<eval::StudyAxis> axes, std::int64_t trials,
                       std::int64_t worlds) {
  eval::Study study;
  study.base.name = "robustness/hand";
  study.base.file = "hand.toml";
  study.base.hash = "0123";
  study.base.scenario.title = "Made by hand";
  study.base.scenario.question = "Do the statistics hold?";
  study.base.scenario.study.axes = std::move(axes);
  study.base.scenario.study.worlds = worlds;
  study.kind = &hand_kind();
  study.methods = hand_methods(study.base.scenario);
  study.trials = trials;
  for (auto& values : eval::study_points(study.base.scenario.study)) {
    study.points.push_back({std::move(values), study.base});
  }
  return study;
}

eval::Study hand_study(std::int64_t trials, std::int64_t worlds) {
  return hand_study({{"sighting.noise_m", {0.1}, ""}}, trials, worlds);
}

eval::TrialRecord hand_record(eval::TrialId id, const HandAnswer& plain, const HandAnswer& robust) {
  eval::TrialRecord record;
  record.id = id;
  record.results = {hand_result("plain", plain), hand_result("robust", robust)};
  record.wall_s = 0.5;
  record.cpu_s = 0.4;
  record.resident_bytes = 50'000'000;
  return record;
}

eval::TrialRecord failed_record(eval::TrialId id, eval::TrialStatus status,
                                const std::string& cause) {
  eval::TrialRecord record;
  record.id = id;
  record.status = status;
  record.cause = cause;
  return record;
}

eval::Table hand_table(const eval::Study& study, const std::vector<int>& plain,
                       const std::vector<int>& robust) {
  std::vector<eval::TrialRecord> records;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const auto answer = [k](int success, double scale) {
      return HandAnswer{double(success), 1.0 - success, scale * (1.0 + 0.1 * double(k % 5)), 0.5};
    };
    records.push_back(hand_record({0, static_cast<std::int64_t>(k)}, answer(plain[k], 2.0),
                                  answer(robust[k], 1.0)));
  }
  return eval::study_table(study, std::move(records));
}

}  // namespace honka::test
