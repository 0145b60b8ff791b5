// honka locate on lists of a tilted sensor: stars in the plane or in space.
#include <fstream>
#include <iomanip>

#include "tests/support/space_world.h"
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::Json;
using honka::test::run_honka;
using honka::test::SpacePoints;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

const honka::Pose3 kTilted = honka::test::tilted_pose(12.0, -18.0, 0.8);

void write_feet(const fs::path& file, const SpacePoints& feet) {
  std::ofstream stream(file);
  stream << "x_m,y_m,z_m\n" << std::setprecision(12);
  for (const Eigen::Vector3d& p : feet) stream << p.x() << "," << p.y() << "," << p.z() << "\n";
}

/// map.csv of a rough ground, and list.csv of it by the tilted sensor.
void write_tilted_case(const TemporaryFolder& folder) {
  const SpacePoints map = honka::test::stems_on(honka::test::rough_ground);
  write_feet(folder / "map.csv", map);
  write_feet(folder / "list.csv", honka::test::seen_in_space(map, kTilted));
}

std::vector<std::string> ask_stars(const std::string& stars, const std::string& map = "map.csv",
                                   const std::string& list = "list.csv") {
  return {"locate", map, list, "--tolerance-m2", "0.001", "--stars", stars, "--json"};
}

}  // namespace

TEST_CASE(
    "locate --stars space finds a tilted list with height, roll and pitch, and plane does not") {
  const TemporaryFolder folder;
  write_tilted_case(folder);
  const auto in_space = run_honka(ask_stars("space"), folder.path());
  REQUIRE(in_space.exit_code == 0);
  const Json answer = Json::parse(in_space.out);
  REQUIRE(answer["accepted"].get<bool>());
  CHECK(answer["x_m"].get<double>() == Approx(41.0).margin(1e-6));
  CHECK(answer["y_m"].get<double>() == Approx(38.0).margin(1e-6));
  CHECK(answer["z_m"].get<double>() == Approx(kTilted.translation().z()).margin(1e-6));
  CHECK(answer["yaw_rad"].get<double>() == Approx(0.8).margin(1e-6));
  CHECK(answer["roll_rad"].get<double>() == Approx(honka::deg_to_rad(12.0)).margin(1e-6));
  CHECK(answer["pitch_rad"].get<double>() == Approx(honka::deg_to_rad(-18.0)).margin(1e-6));

  const auto in_plane = run_honka(ask_stars("plane"), folder.path());
  REQUIRE(in_plane.exit_code == 0);
  const Json refused = Json::parse(in_plane.out);
  CHECK(refused["verdict"] == "not_in_map");
  CHECK_FALSE(refused.contains("z_m"));
  auto text = ask_stars("space");
  text.pop_back();
  CHECK_THAT(run_honka(text, folder.path()).out, Catch::Contains("roll 0.20944 rad"));
}

TEST_CASE("A refused list in space has no height and no tilt") {
  const TemporaryFolder folder;
  write_tilted_case(folder);
  write_feet(folder / "few.csv", {{1, 2, 3}, {4, 5, 6}});
  const auto outcome = run_honka(ask_stars("space", "map.csv", "few.csv"), folder.path());
  REQUIRE(outcome.exit_code == 0);
  const Json answer = Json::parse(outcome.out);
  CHECK(answer["verdict"] == "too_few_stems");
  for (const char* key : {"z_m", "roll_rad", "pitch_rad"}) CHECK(answer[key].is_null());
}

TEST_CASE("Heights that are missing are told by their place") {
  const TemporaryFolder folder;
  write_tilted_case(folder);
  std::ofstream(folder / "plan.csv") << "x_m,y_m\n1,2\n3,4\n";
  std::ofstream(folder / "gap.csv") << "x_m,y_m,z_m\n1,2,3\n4,5,\n";
  std::ofstream(folder / "nan.csv") << "x_m,y_m,z_m\n1,2,nan\n";
  check_refused(run_honka(ask_stars("space", "plan.csv"), folder.path()),
                {"plan.csv:1:1", "z_m", "height"});
  check_refused(run_honka(ask_stars("space", "map.csv", "plan.csv"), folder.path()),
                {"plan.csv:1:1", "z_m"});
  check_refused(run_honka(ask_stars("space", "map.csv", "gap.csv"), folder.path()),
                {"gap.csv:3:5", "z_m"});
  check_refused(run_honka(ask_stars("space", "map.csv", "nan.csv"), folder.path()),
                {"nan.csv:2:5"});
  CHECK(run_honka(ask_stars("plane", "map.csv", "gap.csv"), folder.path()).exit_code == 0);
}

TEST_CASE("locate --stars is refused for other methods and words") {
  const TemporaryFolder folder;
  write_tilted_case(folder);
  const std::string stars = GENERATE("plane", "space");
  auto consensus = ask_stars(stars);
  consensus.insert(consensus.end(), {"--method", "consensus"});
  check_refused(run_honka(consensus, folder.path()), {"--stars", "li2020"});
  check_refused(run_honka(ask_stars("3d"), folder.path()), {"--stars", "space"});
}
