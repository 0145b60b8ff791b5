// honka locate --method consensus: the index of a map in a file, one for many lists, and priors.
#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/support/stem_csv.h"
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::Outcome;
using honka::test::read_case_poses;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

const fs::path kEasyCases = HONKA_SOURCE_DIR "/tests/data/localization_cases/easy";
const fs::path kExactCases = HONKA_SOURCE_DIR "/tests/data/localization_cases/exact";

Outcome locate_by_consensus(const TemporaryFolder& folder, const fs::path& cases,
                            const std::vector<std::string>& locals,
                            const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"locate", (cases / "map.csv").string()};
  for (const std::string& local : locals) arguments.push_back((cases / (local + ".csv")).string());
  arguments.insert(arguments.end(), {"--method", "consensus", "--json"});
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_honka(arguments, folder.path());
}

std::vector<Json> answers_of(const Outcome& outcome) {
  std::vector<Json> answers;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
  return answers;
}

/// The answers without what differs from run to run.
std::vector<Json> without_times(std::vector<Json> answers) {
  for (Json& answer : answers) {
    answer.erase("time_ms");
    answer.erase("map_ms");
  }
  return answers;
}

void check_right(const Json& answer, const honka::Pose2& truth) {
  CAPTURE(answer.dump());
  REQUIRE(answer["accepted"].get<bool>());
  CHECK(std::hypot(answer["x_m"].get<double>() - truth.translation_m.x(),
                   answer["y_m"].get<double>() - truth.translation_m.y()) < 0.5);
  const double yaw_rad = answer["yaw_rad"];
  CHECK(std::abs(honka::wrap_to_pi(yaw_rad - truth.yaw_rad)) < 0.044);
}

std::vector<std::string> names_of(const std::vector<honka::test::CasePose>& poses) {
  std::vector<std::string> names;
  for (const auto& pose : poses) names.push_back(pose.name);
  return names;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace

TEST_CASE("consensus finds every committed case, from one index") {
  for (const fs::path& cases : {kExactCases, kEasyCases}) {
    const auto poses = read_case_poses(cases / "poses.csv");
    const TemporaryFolder folder;
    const Outcome outcome = locate_by_consensus(folder, cases, names_of(poses));
    REQUIRE(outcome.exit_code == 0);
    const auto answers = answers_of(outcome);
    REQUIRE(answers.size() == poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      check_right(answers[i], poses[i].T_map_local);
      CHECK(answers[i].contains("map_ms") == (i == 0));
    }
  }
}

TEST_CASE("an index is written once, then loaded, and gives the same answers") {
  const auto poses = read_case_poses(kEasyCases / "poses.csv");
  const TemporaryFolder folder;
  const auto names = names_of(poses);
  const Outcome without = locate_by_consensus(folder, kEasyCases, names);
  const Outcome first = locate_by_consensus(folder, kEasyCases, names, {"--index", "map.index"});
  REQUIRE(first.exit_code == 0);
  CHECK(first.err.empty());
  CHECK(folder.entries() == 1);  // no temporary file is left
  const auto written = fs::last_write_time(folder / "map.index");
  const std::string bytes = read_text(folder / "map.index");
  const Outcome second = locate_by_consensus(folder, kEasyCases, names, {"--index", "map.index"});
  REQUIRE(second.exit_code == 0);
  CHECK(fs::last_write_time(folder / "map.index") == written);
  CHECK(read_text(folder / "map.index") == bytes);
  CHECK(without_times(answers_of(first)) == without_times(answers_of(second)));
  CHECK(without_times(answers_of(first)) == without_times(answers_of(without)));
}

TEST_CASE("the index of another map is replaced, and that is said") {
  const auto poses = read_case_poses(kEasyCases / "poses.csv");
  const TemporaryFolder folder;
  REQUIRE(locate_by_consensus(folder, kExactCases, {"exact_n1_k12"}, {"--index", "map.index"})
              .exit_code == 0);
  const std::string foreign = read_text(folder / "map.index");
  const Outcome outcome =
      locate_by_consensus(folder, kEasyCases, names_of(poses), {"--index", "map.index"});
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, Catch::Contains("map.index holds the index of another map"));
  check_right(answers_of(outcome).front(), poses.front().T_map_local);
  CHECK(read_text(folder / "map.index") != foreign);
}

TEST_CASE("a file that is no index, or a damaged one, is refused and left as it is") {
  const TemporaryFolder folder;
  REQUIRE(locate_by_consensus(folder, kEasyCases, {"easy_n1_k12"}, {"--index", "good"}).exit_code ==
          0);
  const std::string good = read_text(folder / "good");
  std::string flipped = good;
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 0x40);
  const std::vector<std::pair<std::string, std::string>> kBad = {
      {"empty", ""},
      {"words", "x_m,y_m\n1,2\n"},
      {"short", good.substr(0, good.size() / 2)},
      {"head", good.substr(0, 12)},
      {"flipped", flipped},
      {"long", good + "more"}};
  for (const auto& [name, text] : kBad) {
    CAPTURE(name);
    write_text(folder / name, text);
    check_refused(locate_by_consensus(folder, kEasyCases, {"easy_n1_k12"}, {"--index", name}),
                  {"--index", name, "delete"});
    CHECK(read_text(folder / name) == text);
  }
}

TEST_CASE("an index where none can be: a folder, a missing parent is made, li2020 has none") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "there");
  check_refused(locate_by_consensus(folder, kEasyCases, {"easy_n1_k12"}, {"--index", "there"}),
                {"there"});
  CHECK(locate_by_consensus(folder, kEasyCases, {"easy_n1_k12"}, {"--index", "new/map.index"})
            .exit_code == 0);
  CHECK(fs::exists(folder / "new/map.index"));
  check_refused(run_honka({"locate", (kEasyCases / "map.csv").string(),
                           (kEasyCases / "easy_n1_k12.csv").string(), "--index", "map.index"},
                          folder.path()),
                {"--index", "--method consensus"});
}

TEST_CASE("a prior about the place keeps the answer, one elsewhere refuses it") {
  const TemporaryFolder folder;
  const auto prior = [](const Eigen::Vector2d& place_m, double radius_m) {
    return std::to_string(place_m.x()) + "," + std::to_string(place_m.y()) + "," +
           std::to_string(radius_m);
  };
  for (const char* method : {"li2020", "consensus"}) {
    const auto ask = [&](const std::string& text) {
      return run_honka({"locate", (kExactCases / "map.csv").string(),
                        (kExactCases / "exact_n1_k12.csv").string(), "--method", method,
                        "--tolerance-m2", "0.001", "--prior", text, "--json"},
                       folder.path());
    };
    const auto exact = read_case_poses(kExactCases / "poses.csv");
    const auto pose = std::find_if(exact.begin(), exact.end(),
                                   [](const auto& p) { return p.name == "exact_n1_k12"; });
    REQUIRE(pose != exact.end());
    const Eigen::Vector2d place_m = pose->T_map_local.translation_m;
    const Outcome near = ask(prior(place_m + Eigen::Vector2d(3.0, 0.0), 10.0));
    REQUIRE(near.exit_code == 0);
    check_right(answers_of(near).front(), pose->T_map_local);
    const Outcome far = ask(prior(place_m + Eigen::Vector2d(100.0, 0.0), 10.0));
    REQUIRE(far.exit_code == 0);
    CHECK_FALSE(answers_of(far).front()["accepted"].get<bool>());
  }
}

TEST_CASE("a prior in another form is told in one line") {
  const TemporaryFolder folder;
  for (const char* text : {"", "1,2", "1,2,3,4", "1,2,x", "1,2,0", "1,2,-5", "1,nan,5", "1,2,inf",
                           "1;2;3", "1,,3", "1,2,3,", "1 2 3", "1e999,2,3"}) {
    CAPTURE(text);
    check_refused(
        run_honka({"locate", (kEasyCases / "map.csv").string(),
                   (kEasyCases / "easy_n1_k12.csv").string(), std::string("--prior=") + text},
                  folder.path()),
        {"--prior"});
  }
  const Outcome negative =
      run_honka({"locate", (kEasyCases / "map.csv").string(),
                 (kEasyCases / "easy_n1_k12.csv").string(), "--prior", "-5,3,10"},
                folder.path());
  CHECK(negative.exit_code == 0);
}
