#include "eval/io/tum.h"

#include "eval/io/context.h"
#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

TEST_CASE("TUM: goes round at full precision") {
  const TemporaryFolder folder;
  const std::vector<TimedPose> poses = {
      {1305031098.6659, pose_from_rpy({674321.123, 1.0 / 3.0, -0.0}, 0.1, -0.2, 3.1)},
      {1305031098.7001, Pose3::Identity()}};
  write_tum(folder / "a.tum", poses);
  const auto back = read_tum(folder / "a.tum");
  REQUIRE(back.size() == 2);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CHECK(back[i].time_s == poses[i].time_s);
    CHECK(back[i].pose.translation() == poses[i].pose.translation());
    CHECK(back[i].pose.linear().isApprox(poses[i].pose.linear(), 1e-15));
  }
}

TEST_CASE("TUM: tabs, CRLF, comments, bad input with line and column") {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.tum").string();
  write_raw(path, "# ground truth\r\n1\t2  3 4 0 0 0 1\r\n");
  CHECK(read_tum(path)[0].pose.translation() == Eigen::Vector3d(2, 3, 4));
  struct Bad {
    std::string content, error;
  };
  const std::vector<Bad> cases = {
      {"# none\n", ": no poses; give rows of t x y z qx qy qz qw"},
      {"1 2 3 4 0 0 1\n", ":1:1: 7 numbers where a TUM row has 8: t x y z qx qy qz qw"},
      {"1 2 3 4 0 0 0 1\n2 2 3 four 0 0 0 1\n",
       ":2:7: column 'z': 'four' is not a number; use digits and a decimal point"},
      {"1 2 3 4 0 0 0 0\n",
       ":1:9: quaternion of length 0; a rotation has length 1, and the order is qx qy qz qw"},
      {"1 2 3 4 0 0 0 1\n1 2 3 4 0 0 0 1\n",
       ":2:1: time 1 does not follow the one before; sort the rows"},
      {"1 2 nan 4 0 0 0 1\n",
       ":1:5: column 'y': 'nan' is not finite; mend the number or take the row out"},
  };
  for (const Bad& bad : cases) {
    write_raw(path, bad.content);
    CHECK(user_error_of([&] { (void)read_tum(path); }) == path + bad.error);
  }
}

TEST_CASE("TUM: positions alone where they suffice, never a mixture") {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.tum").string();
  write_raw(path, "1 2 3 4\n2 3 4 5\n");
  const TimedPoses bare = read_tum_trajectory(path);
  CHECK_FALSE(bare.has_rotations);
  REQUIRE(bare.poses.size() == 2);
  CHECK(bare.poses[1].time_s == 2.0);
  CHECK(bare.poses[1].pose.translation() == Eigen::Vector3d(3, 4, 5));
  CHECK(user_error_of([&] { (void)read_tum(path); }) ==
        path + ":1:1: 4 numbers where a TUM row has 8: t x y z qx qy qz qw");
  for (const std::string& content :
       {std::string("1 2 3 4\n2 2 3 4 0 0 0 1\n"), std::string("1 2 3 4 0 0 0 1\n2 2 3 4\n"),
        std::string("1 2 3 4\n2 3 4\n")}) {
    write_raw(path, content);
    CHECK_THAT(user_error_of([&] { (void)read_tum_trajectory(path); }),
               Catch::StartsWith(path + ":2:1: ") && Catch::Contains("or all have 4: t x y z"));
  }
  write_raw(path, "1 2 3 4 0 0 0 1\n");
  CHECK(read_tum_trajectory(path).has_rotations);
}

TEST_CASE("TUM: the published trajectory can be read") {
  const auto data =
      std::filesystem::path(HONKA_SOURCE_DIR).parent_path() / "shared/data/trajectories";
  if (!std::filesystem::exists(data)) {
    WARN("skipped: no " << data);
    return;
  }
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    const std::string name = entry.path().filename().string();
    if (name.find("freiburg1_xyz") == std::string::npos || !name.ends_with(".txt")) continue;
    CHECK(read_tum(entry.path()).size() > 700);
  }
}

TEST_CASE("context: names what a result came from") {
  const auto entries = Context(2, 42).entries();
  for (const char* key : {"schema_version", "commit", "dirty", "compiler", "build_type", "host",
                          "cpu", "start_time", "wall_time_s"}) {
    INFO(key);
    CHECK_FALSE(entries.at(key).empty());
  }
  CHECK(entries.at("threads") == "2");
  CHECK(entries.at("seed") == "42");
  CHECK(entries.at("isa") == "avx2");
  CHECK(entries.at("start_time").back() == 'Z');
}
