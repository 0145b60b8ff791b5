#include "eval/study/study_results.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "eval/io/safe_file.h"
#include "eval/metrics/statistics.h"
#include "eval/report/summary.h"
#include "eval/study/study_worst.h"
#include "tests/eval/io/temporary_folder.h"
#include "tests/eval/study/hand_study.h"

using namespace honka::eval;
using honka::test::failed_record;
using honka::test::hand_record;
using honka::test::hand_study;
using honka::test::HandAnswer;
using honka::test::TemporaryFolder;

namespace {

/// Trials of every point: plain finds two of three, robust all but the tenth; the third fails.
Table ordinary_trials(const Study& study) {
  std::vector<TrialRecord> records;
  for (std::size_t point = 0; point < study.points.size(); ++point) {
    for (std::int64_t trial = 0; trial < study.trials; ++trial) {
      const TrialId id{static_cast<std::int64_t>(point), trial};
      if (trial == 3) {
        records.push_back(failed_record(id, TrialStatus::kTimedOut, "600 s are over"));
        continue;
      }
      const double plain = trial % 3 == 0 ? 0.0 : 1.0, robust = trial % 10 == 9 ? 0.0 : 1.0;
      const double error_m = 0.1 + 0.01 * static_cast<double>(trial % 7);
      records.push_back(hand_record(id, {plain, 1.0 - plain, 2.0 * error_m, 0.1, 9.0, 1.5},
                                    {robust, 0.0, error_m, 0.1, 9.0, 2.5}));
    }
  }
  return study_table(study, std::move(records));
}

StudyOutcome write_ordinary(const Study& study, const TemporaryFolder& folder) {
  return write_study_results(study, ordinary_trials(study), Context(1, 1), folder.path(),
                             "honka study hand.toml");
}

nlohmann::json summary_in(const TemporaryFolder& folder) {
  return nlohmann::json::parse(read_text_file(folder.path() / "summary.json"));
}

/// No figure of the report is left undrawn or points to a file that is not there.
void check_figures(const TemporaryFolder& folder, std::size_t expected) {
  const Summary summary = read_summary(folder.path() / "summary.json");
  CHECK(summary.report.figures.size() == expected);
  for (const ReportFigure& figure : summary.report.figures) {
    CAPTURE(figure.title, figure.notice);
    const bool no_gnuplot = figure.notice.find("not installed") != std::string::npos;
    CHECK((no_gnuplot || std::filesystem::is_regular_file(folder.path() / figure.file)));
  }
}

std::vector<StudyAxis> noise_axis() { return {{"sighting.noise_m", {0.1, 0.2, 0.4}, ""}}; }

}  // namespace

TEST_CASE("a study's folder: summary by the interface's keys, trials.h5, report and figures") {
  const TemporaryFolder folder;
  const Study study = hand_study(noise_axis(), 40, 40);
  const StudyOutcome outcome = write_ordinary(study, folder);
  const auto json = summary_in(folder);
  CHECK(json["results_digest"] == outcome.digest);
  const Table trials = ordinary_trials(study);
  CHECK(outcome.digest == results_digest({&trials}));
  CHECK(read_table(folder.path() / "trials.h5", "trials").rows() == trials.rows());
  CHECK(read_table(folder.path() / "trials.h5", "frames").rows() == 0);
  const auto& rows = json["tables"]["hand"]["rows"];
  REQUIRE(rows.size() == 6);
  const auto& plain = rows[2];
  CHECK(plain["sighting.noise_m"] == 0.2);
  CHECK(plain["method"] == "plain");
  CHECK(plain["trials"] == 40);
  CHECK(plain["failed"] == 1);
  CHECK(plain["failed_by"]["timed_out"] == 1);
  // 26 of 40: trial 3 would have been lost anyway.
  CHECK(plain["success_rate"] == Approx(26.0 / 40.0));
  CHECK(plain["success_interval"][0] == Approx(wilson_interval(26, 40)->low));
  CHECK(plain["wrong_rate"] == Approx(13.0 / 40.0));
  CHECK(plain["translation_error_m_n"] == 26);
  CHECK(plain["error_over_bound"].get<double>() ==
        Approx(plain["translation_error_m"].get<double>() / 0.1));
  CHECK(plain["time_ms"]["p50"] == 1.5);
  CHECK(plain["resident_mb"] == 50.0);
  CHECK(json["scenario"]["study.vary.sighting.noise_m"] == nlohmann::json({0.1, 0.2, 0.4}));
  CHECK(json["report"]["scenario_text"].get<std::string>().find(
            "[study.vary]\nsighting.noise_m = [0.1, 0.2, 0.4]\n") != std::string::npos);
  CHECK(json["tables"]["paired"]["rows"].size() == 8);
  CHECK(json["tables"]["convergence"]["rows"].size() > 4);
  CHECK(json["metrics"]["failed_trials"]["value"] == 3.0);
  CHECK(json["metrics"]["robust_success_rate"]["value"] == Approx(35.0 / 40.0));
  check_figures(folder, 6);
  CHECK(std::filesystem::file_size(folder.path() / "report.html") > 10000);
}

TEST_CASE("the digits of a summary depend on the study and its trials alone") {
  const TemporaryFolder first, second;
  const Study study = hand_study(noise_axis(), 40, 4);
  (void)write_ordinary(study, first);
  (void)write_ordinary(study, second);
  auto one = summary_in(first), two = summary_in(second);
  one.erase("context");
  two.erase("context");
  CHECK(one == two);
  CHECK(read_text_file(first.path() / "figures/success.svg") ==
        read_text_file(second.path() / "figures/success.svg"));
}

TEST_CASE("figures of an earlier merge do not stay") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "figures");
  std::ofstream(folder.path() / "figures/of_before.svg") << "<svg/>";
  std::ofstream(folder.path() / "shard_0_of_1.h5") << "trials";
  (void)write_ordinary(hand_study(noise_axis(), 12, 12), folder);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "figures/of_before.svg"));
  CHECK(std::filesystem::exists(folder.path() / "shard_0_of_1.h5"));
}

TEST_CASE("studies of two and three axes, of words and of lists are drawn") {
  const StudyAxis noise{"sighting.noise_m", {0.1, 0.2}, ""};
  const StudyAxis words{
      "forest.spacing.process", {std::string("rows"), std::string("strauss")}, ""};
  const StudyAxis counts{"sighting.stems", {std::int64_t{5}, std::int64_t{10}}, ""};
  const auto figures_of = [](const Study& study, std::size_t expected) {
    const TemporaryFolder folder;
    (void)write_ordinary(study, folder);
    check_figures(folder, expected);
  };
  figures_of(hand_study({words}, 12, 12), 6);
  figures_of(hand_study({noise, words}, 12, 12), 7);
  figures_of(hand_study({words, noise}, 12, 12), 7);
  figures_of(hand_study({noise, words, counts}, 12, 12), 11);
  Study list = hand_study({noise}, 12, 12);
  list.base.scenario.study.combine = "list";
  list.base.scenario.study.axes.push_back(words);
  for (std::size_t k = 0; k < 2; ++k) list.points[k].values.push_back(words.values[k]);
  figures_of(list, 6);
}

TEST_CASE(
    "no success, one trial and nothing but failures are results too, what is not there is null") {
  const auto written = [](const Study& study, const std::vector<TrialRecord>& records) {
    const TemporaryFolder folder;
    (void)write_study_results(study, study_table(study, records), Context(1, 1), folder.path(), "");
    CHECK(summary_in(folder)["report"]["tables"].dump().find("nan") == std::string::npos);
    return summary_in(folder)["tables"]["hand"]["rows"][0];
  };
  const HandAnswer lost{0.0, 1.0};
  const Study one = hand_study(1, 1), two = hand_study(2, 2);
  const auto single = written(one, {hand_record({0, 0}, {1.0, 0.0, 0.2, 0.1}, lost)});
  CHECK(single["success_rate"] == 1.0);
  CHECK(single["translation_error_m"] == 0.2);
  CHECK(single["translation_error_m_interval"].is_null());
  const auto none =
      written(two, {hand_record({0, 0}, lost, lost), hand_record({0, 1}, lost, lost)});
  CHECK(none["success_rate"] == 0.0);
  CHECK(none["translation_error_m"].is_null());
  CHECK(none["error_over_bound"].is_null());
  const auto failed = written(two, {failed_record({0, 0}, TrialStatus::kCrashed, "signal 6"),
                                    failed_record({0, 1}, TrialStatus::kOutOfMemory, "")});
  CHECK(failed["trials"] == 2);
  CHECK(failed["failed"] == 2);
  CHECK(failed["success_rate"] == 0.0);
  CHECK(failed["success_interval"][1] == Approx(wilson_interval(0, 2)->high));
  CHECK(failed["time_ms"]["p50"].is_null());
}

TEST_CASE("the worst trials: failed, wrong, the largest errors, each with its command") {
  const Study study = hand_study(40, 40);
  const ReportTable worst = worst_trials(study, ordinary_trials(study));
  REQUIRE(worst.rows.size() == 1 + 2 + 8);
  CHECK(worst.rows[0][1].text == "3");
  CHECK(worst.rows[0][2].text == "all");
  CHECK(worst.rows[0][3].text == "timed_out: 600 s are over");
  CHECK(worst.rows[0][4].text == replay_command(study, {0, 3}));
  CHECK(worst.rows[1][1].text == "0");
  CHECK(worst.rows[1][2].text == "plain");
  CHECK(worst.rows[1][3].text == "wrong");
  // The largest error is 0.32 m, in the first of trials 6, 13, 20 … that plain finds.
  CHECK(worst.rows[3][1].text == "13");
  CHECK(worst.rows[3][3].text == "translation_error_m 0.32");
}

TEST_CASE("the terminal shows each point and method, the verdict and the width") {
  const TemporaryFolder folder;
  const StudyOutcome outcome = write_ordinary(hand_study(noise_axis(), 40, 40), folder);
  CHECK(outcome.table.find("robust") != std::string::npos);
  CHECK(outcome.table.find("65.0 [49.5 – 77.9]") != std::string::npos);
  CHECK(outcome.table.find("robust succeeds more often than plain: +22.5 %") != std::string::npos);
  CHECK(outcome.table.find("±14.2 % after 40 trials") != std::string::npos);
  CHECK(outcome.table.find("1 timed_out") != std::string::npos);
}
