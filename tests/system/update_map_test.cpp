// honka update-map, as a user runs it: a thinned stand, lists along a road, a new stem list.
#include <cmath>
#include <fstream>
#include <sstream>

#include "algo/types/pose.h"
#include "algo/types/random.h"
#include "tests/support/stem_csv.h"
#include "tests/system/program.h"

namespace {

using honka::Pose2;
using honka::RandomStream;
using honka::test::check_refused;
using honka::test::Json;
using honka::test::Outcome;
using honka::test::read_stems;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

/// 100 × 40 m, a stem each 4 m or so; every third of the map is felled and every eleventh tree is
/// not in it. MAP.csv has columns that honka does not know.
struct FelledPlot {
  explicit FelledPlot(const TemporaryFolder& folder) {
    std::ofstream map(folder / "map.csv");
    map << "# plot 12\nid,x_m,y_m,dbh_m,species\n";
    int number = 0;
    for (std::uint64_t iy = 0; iy < 10; ++iy) {
      for (std::uint64_t ix = 0; ix < 25; ++ix, ++number) {
        RandomStream random(4, "felled_plot", {ix, iy});
        const double x = 4.0 * static_cast<double>(ix) + random.uniform(-1.4, 1.4);
        const double y = 4.0 * static_cast<double>(iy) + random.uniform(-1.4, 1.4);
        const bool unmapped = number % 11 == 5, is_felled = !unmapped && number % 3 == 0;
        if (!unmapped) map << "t" << number << "," << x << "," << y << ",0.25,\"pine, old\"\n";
        if (!is_felled) standing.emplace_back(x, y);
        felled += is_felled ? 1 : 0;
        missing += unmapped ? 1 : 0;
      }
    }
    for (int k = 0; k < 30; ++k) {
      lists.push_back("list" + std::to_string(k) + ".csv");
      write_list(folder / lists.back(), {{10.0 + 2.6 * k, 18.0 + (k % 2)}, 0.1});
    }
  }

  void write_list(const fs::path& file, const Pose2& T_map_sensor) const {
    std::ofstream out(file);
    out << "x_m,y_m\n";
    for (const Eigen::Vector2d& stem : standing) {
      const Eigen::Vector2d local = T_map_sensor.inverse() * stem;
      if (local.norm() < 30.0 && std::abs(std::atan2(local.y(), local.x())) < 1.83) {
        out << local.x() << "," << local.y() << "\n";
      }
    }
  }

  std::vector<Eigen::Vector2d> standing;
  std::vector<std::string> lists;
  int felled = 0, missing = 0;
};

Outcome update_map(const TemporaryFolder& folder, const FelledPlot& plot,
                   const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {"update-map", "map.csv"};
  arguments.insert(arguments.end(), plot.lists.begin(), plot.lists.end());
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_honka(arguments, folder.path());
}

Eigen::Vector2d place_of(const Json& stem) {
  return {stem["x_m"].get<double>(), stem["y_m"].get<double>()};
}

double distance_to_nearest(const Eigen::Vector2d& place,
                           const std::vector<Eigen::Vector2d>& stems) {
  double nearest = 1e9;
  for (const Eigen::Vector2d& stem : stems) nearest = std::min(nearest, (stem - place).norm());
  return nearest;
}

}  // namespace

TEST_CASE("update-map writes what stands, keeps the columns of rows that stay, and tells") {
  const TemporaryFolder folder;
  const FelledPlot plot(folder);
  const Outcome outcome = update_map(folder, plot, {"--out", "new.csv", "--json"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json json = Json::parse(outcome.out);
  CHECK(json["lists"] == 30);
  CHECK(json["accepted"] == 30);
  CHECK(json["views"].size() == 30);
  CHECK(json["retired"].size() > 0.7 * plot.felled);
  CHECK(json["added"].size() > 0.7 * plot.missing);
  CHECK(json["stems_after"].get<std::size_t>() ==
        json["stems_before"].get<std::size_t>() - json["retired"].size() + json["added"].size());
  const auto after = read_stems(folder / "new.csv");
  CHECK(after.size() == json["stems_after"]);
  for (const Json& stem : json["added"]) {
    CHECK(distance_to_nearest(place_of(stem), plot.standing) < 0.1);
  }
  const std::string text = read_text(folder / "new.csv"), before = read_text(folder / "map.csv");
  CHECK_THAT(text, Catch::StartsWith("# plot 12\nid,x_m,y_m,dbh_m,species\n"));
  std::vector<std::string> rows;
  std::istringstream lines(before);
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  for (const Json& stem : json["retired"]) {
    const std::string& row = rows.at(stem["line"].get<std::size_t>() - 1);
    CHECK_THAT(row, Catch::StartsWith(stem["id"].get<std::string>() + ","));
    CHECK(text.find(row + "\n") == std::string::npos);
    CHECK(distance_to_nearest(place_of(stem), plot.standing) > 0.5);
    rows[stem["line"].get<std::size_t>() - 1] = rows[0];
  }
  for (const std::string& row : rows) CHECK(text.find(row + "\n") != std::string::npos);
}

TEST_CASE("update-map by li2020, and in plain words, refused lists change nothing") {
  const TemporaryFolder folder;
  const FelledPlot plot(folder);
  const Outcome by_li = update_map(folder, plot, {"--out", "new.csv", "--method", "li2020"});
  CHECK(by_li.exit_code == 0);
  CHECK_THAT(by_li.out, Catch::Contains("accepted by li2020") && Catch::Contains("map.csv: 227"));
  std::ofstream(folder / "empty.csv") << "x_m,y_m\n";
  const Outcome refused = run_honka(
      {"update-map", "map.csv", "empty.csv", "--out", "same/new.csv", "--json"}, folder.path());
  CAPTURE(refused.err);
  REQUIRE(refused.exit_code == 0);
  CHECK(Json::parse(refused.out)["views"][0]["verdict"] == "too_few_stems");
  CHECK(read_text(folder / "same/new.csv") == read_text(folder / "map.csv"));
}

TEST_CASE("update-map refuses bad input with its place, and writes nothing") {
  const TemporaryFolder folder;
  const FelledPlot plot(folder);
  std::ofstream(folder / "bad.csv") << "x_m,y_m\n1,2\n3,four\n";
  std::ofstream(folder / "two.csv") << "x_m,y_m\n1,2\n3,4\n";
  std::ofstream(folder / "old.csv") << "precious";
  const auto refuse = [&](const std::vector<std::string>& arguments,
                          const std::vector<std::string>& parts) {
    std::vector<std::string> all = {"update-map"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    check_refused(run_honka(all, folder.path()), parts);
  };
  refuse({"map.csv", "list0.csv", "bad.csv", "--out", "old.csv"}, {"bad.csv:3:3"});
  refuse({"bad.csv", "list0.csv", "--out", "old.csv"}, {"bad.csv:3:3"});
  refuse({"two.csv", "list0.csv", "--out", "old.csv"}, {"two.csv"});
  refuse({"none.csv", "list0.csv", "--out", "old.csv"}, {"none.csv"});
  refuse({"map.csv", "list0.csv"}, {"--out"});
  refuse({"map.csv", "--out", "old.csv"}, {"LOCAL"});
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--method", "guess"},
                                                        {"--range-m", "0"},
                                                        {"--range-m", "nan"},
                                                        {"--view-deg", "400"},
                                                        {"--every", "0"},
                                                        {"--tolerance-m2", "nan"}}) {
    CAPTURE(option, value);
    refuse({"map.csv", "list0.csv", "--out", "old.csv", option, value}, {option});
  }
  CHECK(read_text(folder / "old.csv") == "precious");
  refuse({"map.csv", "list0.csv", "--out", "."}, {"."});
}
