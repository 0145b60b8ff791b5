// Key frames of stems and their chain, plain and gzipped; every complaint names its place.
#include "eval/io/frames_csv.h"

#include <cmath>

#include "eval/io/gzip.h"
#include "tests/eval/io/temporary_folder.h"

namespace {

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

const fs::path kFrameCases = fs::path(HONKA_SOURCE_DIR) / "tests/data/slam_cases";

fs::path frames_file(const TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder / "frames.csv", std::ios::binary) << text;
  return folder / "frames.csv";
}

std::string refusal_of(const fs::path& file) {
  try {
    static_cast<void>(read_frames_csv(file));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("frames csv: columns in any order, both names, other columns, frames out of order") {
  const TemporaryFolder folder;
  const auto frames = read_frames_csv(frames_file(
      folder, "# made by hand\ntree,z,frame,y_m,x\n5,0.25,7,2,1\n5,0,-3,5,4\r\n\n6,1,7,-8,1e1\n"));
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].number == -3);
  CHECK(frames[1].number == 7);
  REQUIRE(frames[1].points_m.size() == 2);
  CHECK(frames[1].points_m[0] == Eigen::Vector3d(1.0, 2.0, 0.25));
  CHECK(frames[1].points_m[1] == Eigen::Vector3d(10.0, -8.0, 1.0));
}

TEST_CASE("frames csv: gzipped is the same as plain, the shared part has its 120 frames") {
  const TemporaryFolder folder;
  const fs::path packed = kFrameCases / "case0_first_frames.csv.gz";
  const auto one = read_frames_csv(packed);
  const auto two = read_frames_csv(frames_file(folder, read_text_or_gzip(packed)));
  REQUIRE(one.size() == 120);
  REQUIRE(two.size() == 120);
  for (std::size_t l = 0; l < one.size(); ++l) {
    CHECK(one[l].number == static_cast<std::int64_t>(l));
    CHECK(one[l].points_m == two[l].points_m);
    CHECK(one[l].points_m.size() > 80);
  }
}

TEST_CASE("frames csv: complaints name file, line and remedy") {
  const TemporaryFolder folder;
  const std::string head = "frame,x_m,y_m,z_m\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {head + "0,1,2,3\n0,1,2,inf\n", "frames.csv:3:7: column 'z_m'"},
      {head + "0,1,2,3\n0,1,,3\n", "frames.csv:3:5: column 'y_m': empty"},
      {head + "0,1,2,3\n1.5,1,2,3\n", "frames.csv:3:1: column 'frame': '1.5'"},
      {head + "1e18,1,2,3\n", "no whole number"},
      {head + "0,1,2\n", "frames.csv:2:1: 3 cells"},
      {"frame,x_m,x,y_m,z_m\n0,1,1,2,3\n", "a second time"},
      {"fram,x_m,y_m,z_m\n0,1,2,3\n", "did you mean 'frame' by 'fram'?"},
      {head, "no stems"},
      {"", "empty"}};
  for (const auto& [text, part] : cases) {
    INFO(text);
    CHECK_THAT(refusal_of(frames_file(folder, text)), Catch::Contains(part));
  }
  CHECK_THAT(refusal_of(folder / "absent.csv"), Catch::Contains("absent.csv"));
}

TEST_CASE("frames csv: a chain by rows or by numbers, commas or blanks, plain or gzipped") {
  const TemporaryFolder folder;
  auto frames = read_frames_csv(kFrameCases / "case0_first_frames.csv.gz");
  CHECK(read_chain_poses(kFrameCases / "case0_first_chain.csv.gz", frames).size() == 120);
  const std::string row = "1 0 0 4 0 1 0 5 0 0 1 6\n";
  std::ofstream(folder / "chain.txt") << row << row << row << row;
  // Four rows for frames 1 and 3: row k is that of frame k, and frames 0 and 2 saw nothing.
  auto some = read_frames_csv(frames_file(folder, "frame,x_m,y_m,z_m\n3,1,2,0\n1,4,-3,0\n"));
  const FramePoses poses = read_chain_poses(folder / "chain.txt", some);
  REQUIRE(poses.size() == 4);
  CHECK(poses[2].translation() == Eigen::Vector3d(4.0, 5.0, 6.0));
  REQUIRE(some.size() == 4);
  CHECK(some[0].points_m.empty());
  CHECK(some[3].points_m.size() == 1);
  CHECK(some[3].number == 3);
  auto other = read_frames_csv(frames_file(folder, "frame,x_m,y_m,z_m\n8,1,2,0\n9,4,-3,0\n"));
  CHECK_THROWS_WITH(read_chain_poses(folder / "chain.txt", other), Catch::Contains("4 poses"));
}
