// honka locate on stem lists with known poses.
#include <cmath>

#include "tests/support/stem_csv.h"
#include "tests/system/program.h"

namespace {

using honka::test::CasePose;
using honka::test::Json;
using honka::test::read_case_poses;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

/// One answer a case, in order.
std::vector<Json> locate(const fs::path& cases, const std::vector<CasePose>& poses,
                         const std::string& tolerance_m2) {
  std::vector<std::string> arguments = {"locate", (cases / "map.csv").string()};
  for (const CasePose& pose : poses) arguments.push_back((cases / (pose.name + ".csv")).string());
  arguments.insert(arguments.end(),
                   {"--method", "li2020", "--tolerance-m2", tolerance_m2, "--json"});
  const TemporaryFolder folder;
  const auto outcome = run_honka(arguments, folder.path());
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  std::vector<Json> answers;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
  REQUIRE(answers.size() == poses.size());
  return answers;
}

bool lies_within(const Json& answer, const CasePose& truth, double metres, double radians) {
  if (!answer["accepted"]) return false;
  const Eigen::Vector2d place_m(answer["x_m"].get<double>(), answer["y_m"].get<double>());
  const double yaw_rad = answer["yaw_rad"];
  return (place_m - truth.T_map_local.translation_m).norm() <= metres &&
         std::abs(honka::wrap_to_pi(yaw_rad - truth.T_map_local.yaw_rad)) <= radians;
}

void check_keys(const std::vector<Json>& answers) {
  const std::vector<std::string> kKeys = {"local",   "method",  "verdict", "accepted", "x_m",
                                          "y_m",     "yaw_rad", "stems",   "matches",  "agreeing",
                                          "inliers", "margin",  "time_ms"};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    auto expected = kKeys;
    if (i == 0) expected.emplace_back("map_ms");
    CHECK(honka::test::keys(answers[i]) == expected);
    const bool accepted = answers[i]["accepted"];
    CHECK((answers[i]["verdict"] == "accepted") == accepted);
    for (const char* key : {"x_m", "y_m", "yaw_rad"}) CHECK(answers[i][key].is_null() != accepted);
  }
}

fs::path poses_file(const fs::path& cases) { return cases / "poses.csv"; }

/// How many of the answers are accepted, and how many of them right.
std::pair<int, int> accepted_and_right(const std::vector<Json>& answers,
                                       const std::vector<CasePose>& poses) {
  std::pair<int, int> counts{0, 0};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    counts.first += answers[i]["accepted"] ? 1 : 0;
    counts.second += lies_within(answers[i], poses[i], 0.5, 0.044) ? 1 : 0;
  }
  return counts;
}

void check_exact(const fs::path& cases, std::size_t expected) {
  const auto poses = read_case_poses(poses_file(cases));
  REQUIRE(poses.size() == expected);
  const auto answers = locate(cases, poses, "0.001");
  check_keys(answers);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CAPTURE(poses[i].name, answers[i].dump());
    CHECK(lies_within(answers[i], poses[i], 1e-4, 1e-5));
  }
}

const fs::path kCommitted = HONKA_SOURCE_DIR "/tests/data/localization_cases";

}  // namespace

TEST_CASE("locate finds every committed exact case within 1e-4 m and 1e-5 rad") {
  check_exact(kCommitted / "exact", 7);
}

TEST_CASE("locate finds the committed easy cases but the one with two agreeing matches") {
  const auto poses = read_case_poses(poses_file(kCommitted / "easy"));
  const auto answers = locate(kCommitted / "easy", poses, "9");
  check_keys(answers);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CAPTURE(answers[i].dump());
    CHECK(lies_within(answers[i], poses[i], 0.5, 0.044) == (poses[i].name != "easy_n1_k12"));
  }
}

TEST_CASE("a refusal is an answer, in words too") {
  const auto cases = (kCommitted / "easy").string();
  const TemporaryFolder folder;
  const auto outcome =
      run_honka({"locate", cases + "/map.csv", cases + "/easy_n1_k12.csv", "--tolerance-m2", "9"},
                folder.path());
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Contains("easy_n1_k12.csv: refused, not_in_map"));
}

TEST_CASE("locate on all 104 cases: every exact one, 51 of 52 easy ones") {
  const auto cases = honka::test::shared("data/localization_cases");
  if (!fs::exists(cases)) {
    WARN("skipped: " << cases << " is absent");
    return;
  }
  check_exact(cases / "exact", 52);
  const auto poses = read_case_poses(poses_file(cases / "easy"));
  REQUIRE(poses.size() == 52);
  const auto answers = locate(cases / "easy", poses, "9");
  CHECK(accepted_and_right(answers, poses) == std::pair{51, 51});
}
