// honka register on clouds with known poses, and on files that are none.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "algo/types/random.h"
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

/// x_target = R(0.3) x_source + (2, -1), heights 0.5 m apart.
constexpr double kCloudYaw = 0.3, kCloudX = 2.0, kCloudY = -1.0, kCloudZ = 0.5;

void write_file(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// target.csv with x_m,y_m,z_m and other columns, source.csv with x,y,z; flat.csv is the source
/// without heights.
void write_clouds(const TemporaryFolder& folder) {
  honka::RandomStream random(1, "register_test");
  std::string target = "# made here\nid,x_m,y_m,z_m\n", source = "z,x,y\n", flat = "x_m,y_m\n";
  for (int k = 0; k < 60; ++k) {
    const double x = random.uniform(-25.0, 25.0), y = random.uniform(-25.0, 25.0);
    const double z = random.uniform(-1.0, 1.0);
    const auto text = [](double value) { return std::to_string(value); };
    source += text(z) + "," + text(x) + "," + text(y) + "\n";
    flat += text(x) + "," + text(y) + "\n";
    target += "7," + text(std::cos(kCloudYaw) * x - std::sin(kCloudYaw) * y + kCloudX) + "," +
              text(std::sin(kCloudYaw) * x + std::cos(kCloudYaw) * y + kCloudY) + "," +
              text(z + kCloudZ) + "\n";
  }
  write_file(folder.path() / "target.csv", target);
  write_file(folder.path() / "source.csv", source);
  write_file(folder.path() / "flat.csv", flat);
}

Json register_json(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "register");
  arguments.emplace_back("--json");
  const auto outcome = run_honka(arguments, folder.path());
  CAPTURE(outcome.out, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  return Json::parse(outcome.out);
}

void check_is_the_motion(const Json& answer) {
  CHECK(answer["status"] == "registered");
  const std::vector<double> T = answer["T_target_source"];
  REQUIRE(T.size() == 16);
  CHECK(T[0] == Approx(std::cos(kCloudYaw)).margin(1e-3));
  CHECK(T[1] == Approx(-std::sin(kCloudYaw)).margin(1e-3));
  CHECK(T[3] == Approx(kCloudX).margin(0.02));
  CHECK(T[7] == Approx(kCloudY).margin(0.02));
  CHECK(T[11] == Approx(kCloudZ).margin(0.02));
  CHECK((T[12] == 0.0 && T[13] == 0.0 && T[14] == 0.0 && T[15] == 1.0));
  CHECK(answer["rmse_m"].get<double>() < 0.01);
  CHECK(answer["share"] == 1.0);
}

TEST_CASE("honka register finds a cloud in another", "[register]") {
  const TemporaryFolder folder;
  write_clouds(folder);
  const std::vector<std::string> kKeys = {
      "method", "status",        "T_target_source", "rmse_m",    "overlap", "inliers",
      "share",  "lower_bound_m", "gap_m",           "certified", "nodes",   "time_ms"};
  for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
           {"--method", "landmarks"},
           {"--method", "go_icp"},
           {"--method", "go_icp", "--mode", "l0", "--inlier-share", "0.8"}}) {
    std::vector<std::string> arguments = {"target.csv", "source.csv"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Json answer = register_json(folder, arguments);
    CHECK(honka::test::keys(answer) == kKeys);
    CHECK(answer["method"] == how[1]);
    check_is_the_motion(answer);
  }
  const Json certified = register_json(folder, {"target.csv", "source.csv", "--method", "go_icp"});
  CHECK(certified["certified"] == true);
  CHECK(certified["nodes"].get<int>() > 0);

  const auto shown =
      run_honka({"register", "target.csv", "source.csv", "--method", "landmarks"}, folder.path());
  CHECK(shown.exit_code == 0);
  CHECK_THAT(shown.out, Catch::Contains("landmarks: registered"));
}

TEST_CASE("A cloud without heights is planar", "[register]") {
  const TemporaryFolder folder;
  write_clouds(folder);
  const Json answer = register_json(folder, {"flat.csv", "flat.csv", "--method", "icp"});
  CHECK(answer["status"] == "registered");
  CHECK(answer["T_target_source"][11] == Approx(0.0).margin(1e-12));
}

TEST_CASE("A registration that fails is an answer", "[register]") {
  const TemporaryFolder folder;
  write_clouds(folder);
  write_file(folder.path() / "none.csv", "x_m,y_m\n");
  write_file(folder.path() / "line.csv", "x_m,y_m\n0,0\n1,1\n2,2\n3,3\n");
  std::string elsewhere = "x_m,y_m\n";
  honka::RandomStream random(2, "register_test");
  for (int k = 0; k < 40; ++k) {
    elsewhere += std::to_string(random.uniform(-25.0, 25.0)) + "," +
                 std::to_string(random.uniform(-25.0, 25.0)) + "\n";
  }
  write_file(folder.path() / "elsewhere.csv", elsewhere);
  for (const std::string method : {"icp", "go_icp", "landmarks"}) {
    CHECK(register_json(folder, {"target.csv", "none.csv", "--method", method})["status"] ==
          "too_few_points");
    CHECK(register_json(folder, {"line.csv", "source.csv", "--method", method})["status"] ==
          "too_few_points");
    const Json wrong = register_json(folder, {"target.csv", "elsewhere.csv", "--method", method});
    CHECK(wrong["status"] != "registered");
    CHECK(wrong["T_target_source"].size() == 16);
  }
}

TEST_CASE("honka register names what is wrong with its input", "[register]") {
  const TemporaryFolder folder;
  write_clouds(folder);
  write_file(folder.path() / "nan.csv", "x_m,y_m\n0,0\n1,nan\n");
  write_file(folder.path() / "short.csv", "x_m,y_m,z_m\n0,0,0\n1,2\n");
  write_file(folder.path() / "noy.csv", "x_m,z_m\n0,0\n");
  write_file(folder.path() / "far.csv", "x_m,y_m\n1e300,0\n");
  write_file(folder.path() / "empty.csv", "");
  const auto refused = [&](std::vector<std::string> arguments,
                           const std::vector<std::string>& parts) {
    arguments.insert(arguments.begin(), "register");
    check_refused(run_honka(arguments, folder.path()), parts);
  };
  refused({"target.csv", "absent.csv", "--method", "icp"}, {"absent.csv"});
  refused({"target.csv", "nan.csv", "--method", "icp"}, {"nan.csv:3:3", "y_m"});
  refused({"short.csv", "source.csv", "--method", "icp"}, {"short.csv:3:1", "2 cells"});
  refused({"noy.csv", "source.csv", "--method", "icp"}, {"noy.csv:1:1", "y_m"});
  refused({"far.csv", "source.csv", "--method", "icp"}, {"far.csv:2:1", "x_m"});
  refused({"empty.csv", "source.csv", "--method", "icp"}, {"empty.csv", "empty"});
  refused({"target.csv", "source.csv"}, {"--method"});
  refused({"target.csv", "source.csv", "--method", "ndt"}, {"ndt"});
  refused({"target.csv", "source.csv", "--method", "go_icp", "--mode", "slow"}, {"slow"});
  refused({"target.csv", "source.csv", "--method", "icp", "--inlier-share", "0"},
          {"--inlier-share"});
  refused({"target.csv", "source.csv", "--method", "icp", "--inlier-share", "nan"},
          {"--inlier-share"});
}

TEST_CASE("honka help register tells of it", "[register]") {
  const TemporaryFolder folder;
  const auto outcome = run_honka({"help", "register"}, folder.path());
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Contains("TARGET SOURCE") && Catch::Contains("landmarks"));
}

}  // namespace
