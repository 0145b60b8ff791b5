#include "eval/io/kitti.h"

#include "tests/eval/io/temporary_folder.h"

using namespace honka;
using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

TEST_CASE("KITTI: goes round bit for bit") {
  const TemporaryFolder folder;
  std::vector<Pose3> poses = {Pose3::Identity()};
  for (int i = 0; i < 20; ++i) {
    poses.push_back(poses.back() * pose_from_rpy({1.0 / 3.0, 6743.21, -0.0}, 0.3, -0.2, 3.1));
  }
  write_kitti(folder / "a.txt", poses);
  const auto back = read_kitti(folder / "a.txt");
  REQUIRE(back.size() == poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) CHECK(back[i].matrix() == poses[i].matrix());
}

TEST_CASE("KITTI: the order is by rows, rounded matrices become rotations") {
  const TemporaryFolder folder;
  write_raw(folder / "a.txt",
            "0 -1 0 5\t1 0 0 6  0 0 1 7\r\n# note\n"
            "0.995 -0.0998 0 0 0.0998 0.995 0 0 0 0 1 0\n");
  const auto poses = read_kitti(folder / "a.txt");
  REQUIRE(poses.size() == 2);
  CHECK(poses[0].translation() == Eigen::Vector3d(5, 6, 7));
  CHECK(poses[0] * Eigen::Vector3d(1, 0, 0) == Eigen::Vector3d(5, 7, 7));
  CHECK((poses[1].linear().transpose() * poses[1].linear()).isIdentity(1e-14));
  CHECK(yaw_of(poses[1]) == Approx(0.1).margin(1e-3));
}

TEST_CASE("KITTI: bad input with line and column") {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.txt").string();
  const std::string good = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  const std::string no_rotation =
      ": the left 3 x 3 numbers are no rotation; the order is r11 r12 r13 t1 r21 …";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"# none\n", ": no poses; give rows of 12 numbers [R|t]"},
      {good + "1 0 0\n", ":2:1: 3 numbers where a KITTI row has 12: [R|t] by rows"},
      {"1 0 0 0 0 1 0 0 0 0 1 z\n",
       ":1:23: column 't3': 'z' is not a number; use digits and a decimal point"},
      {"1 0 0 0 0 inf 0 0 0 0 1 0\n",
       ":1:11: column 'r22': 'inf' is not finite; mend the number or take the row out"},
      {good + "2 0 0 0 0 2 0 0 0 0 2 0\n", ":2:1" + no_rotation},
      {good + "1 0 0 0 0 1 0 0 0 0 -1 0\n", ":2:1" + no_rotation},
      {"1e300 0 0 0 0 1e300 0 0 0 0 1e300 0\n", ":1:1" + no_rotation},
      {"1e300 1e300 0 0 1e300 -1e300 0 0 0 0 1 0\n", ":1:1" + no_rotation},
      {"0 0 0 0 0 0 0 0 0 0 0 0\n", ":1:1" + no_rotation},
  };
  for (const auto& [content, error] : cases) {
    write_raw(path, content);
    CHECK(user_error_of([&] { (void)read_kitti(path); }) == path + error);
  }
  CHECK_THAT(user_error_of([&] { (void)read_kitti(folder / "none.txt"); }),
             Catch::Contains("none.txt: no such file"));
}
