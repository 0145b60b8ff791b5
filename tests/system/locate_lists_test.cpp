// honka locate on lists and maps that are hardly any: an answer or a verdict, never a crash.
#include <cmath>
#include <fstream>
#include <iomanip>

#include "tests/support/stem_csv.h"
#include "tests/system/program.h"

namespace {

using honka::test::Json;
using honka::test::Outcome;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;
using Places = std::vector<Eigen::Vector2d>;

const fs::path kListCases = HONKA_SOURCE_DIR "/tests/data/localization_cases/exact";

void write_places(const fs::path& file, const Places& places) {
  std::ofstream stream(file);
  stream << "x_m,y_m\n" << std::setprecision(12);
  for (const Eigen::Vector2d& place : places) stream << place.x() << "," << place.y() << "\n";
}

Json ask_lists(const TemporaryFolder& folder, const std::string& method, const fs::path& map,
               const fs::path& local) {
  const Outcome outcome = run_honka({"locate", map.string(), local.string(), "--method", method,
                                     "--tolerance-m2", "0.001", "--json"},
                                    folder.path());
  CAPTURE(method, local.string(), outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("lists that are hardly any get a verdict and no pose") {
  const std::string method = GENERATE("li2020", "consensus");
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, Places>> kLists = {
      {"none", {}},
      {"one", {{5.0, 1.0}}},
      {"two", {{5.0, 1.0}, {3.0, -4.0}}},
      {"same", Places(12, Eigen::Vector2d(5.0, 1.0))},
      {"two_places", {{5, 1}, {5, 1}, {5, 1}, {3, -4}, {3, -4}, {5, 1}, {3, -4}}},
      {"line", {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}, {8, 8}, {9, 9}}},
      {"far", {{1e7, 1e7}, {-1e7, 1e7}, {3e6, -2e6}, {4e6, 5e6}, {1e6, 0}, {0, 1e6}, {2e6, 3e6}}}};
  for (const auto& [name, places] : kLists) {
    CAPTURE(method, name);
    write_places(folder / (name + ".csv"), places);
    const Json answer = ask_lists(folder, method, kListCases / "map.csv", folder / (name + ".csv"));
    CHECK_FALSE(answer["accepted"].get<bool>());
    CHECK(answer["x_m"].is_null());
    CHECK(answer["verdict"] != "accepted");
    CHECK(answer["stems"] == places.size());
    if (places.size() < 3) CHECK(answer["verdict"] == "too_few_stems");
  }
}

TEST_CASE("a number that is none is told by its place") {
  const std::string method = GENERATE("li2020", "consensus");
  const TemporaryFolder folder;
  std::ofstream(folder / "bad.csv") << "x_m,y_m\n1,2\n3,nan\n";
  honka::test::check_refused(
      run_honka({"locate", (kListCases / "map.csv").string(), "bad.csv", "--method", method},
                folder.path()),
      {"bad.csv:3:3"});
}

TEST_CASE("a map of three stems, on a line, or of copies, is answered or told, not crashed upon") {
  const std::string method = GENERATE("li2020", "consensus");
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, Places>> kMaps = {
      {"one", {{1, 2}}},
      {"two", {{1, 2}, {3, 4}}},
      {"three", {{0, 0}, {5, 1}, {2, 6}}},
      {"line", {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}}},
      {"copies", Places(9, Eigen::Vector2d(4.0, 4.0))},
      {"small", {{0, 0}, {5, 1}, {2, 6}, {7, 7}, {-4, 3}, {-2, -5}, {4, -6}, {9, 2}}}};
  for (const auto& [name, places] : kMaps) {
    CAPTURE(method, name);
    write_places(folder / (name + ".csv"), places);
    const Outcome outcome =
        run_honka({"locate", name + ".csv", (kListCases / "exact_n1_k12.csv").string(), "--method",
                   method, "--json"},
                  folder.path());
    CAPTURE(outcome.out, outcome.err);
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 2));
    if (outcome.exit_code == 0) {
      CHECK_FALSE(Json::parse(outcome.out)["accepted"].get<bool>());
    } else {
      CHECK(outcome.complaints().size() == 1);
      CHECK_THAT(outcome.err, Catch::Contains(name + ".csv"));
    }
  }
}

TEST_CASE("a map in UTM coordinates gives the same place, moved, to the millimetre") {
  const std::string method = GENERATE("li2020", "consensus");
  const TemporaryFolder folder;
  const Eigen::Vector2d shift_m(512345.0, 6987654.0);
  Places map = honka::test::read_stems(kListCases / "map.csv");
  for (Eigen::Vector2d& place : map) place += shift_m;
  write_places(folder / "utm.csv", map);
  const fs::path local = kListCases / "exact_n1_k12.csv";
  const Json near = ask_lists(folder, method, kListCases / "map.csv", local);
  const Json far = ask_lists(folder, method, folder / "utm.csv", local);
  REQUIRE(near["accepted"].get<bool>());
  REQUIRE(far["accepted"].get<bool>());
  CHECK(far["x_m"].get<double>() - shift_m.x() == Approx(near["x_m"].get<double>()).margin(1e-3));
  CHECK(far["y_m"].get<double>() - shift_m.y() == Approx(near["y_m"].get<double>()).margin(1e-3));
  CHECK(far["yaw_rad"].get<double>() == Approx(near["yaw_rad"].get<double>()).margin(1e-4));
}
