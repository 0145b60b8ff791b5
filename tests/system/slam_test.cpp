// honka slam on the first frames of the reference case, and on bad input.
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>

#include "eval/io/csv.h"
#include "eval/io/frames_csv.h"
#include "eval/io/tum.h"
#include "tests/system/program.h"

namespace {

using honka::FramePoses;
using honka::Pose3;
using honka::test::check_refused;
using honka::test::contents;
using honka::test::Json;
using honka::test::keys;
using honka::test::read_json;
using honka::test::read_text;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
namespace fs = std::filesystem;

using Words = std::vector<std::string>;

const fs::path kSlamCases = fs::path(HONKA_SOURCE_DIR) / "tests/data/slam_cases";
const std::string kFirstFrames = (kSlamCases / "case0_first_frames.csv.gz").string();
const std::string kFirstChain = (kSlamCases / "case0_first_chain.csv.gz").string();

/// Runs honka slam with some options and gives back its summary.
Json slam(const fs::path& folder, const Words& options, const std::string& out = "map") {
  Words arguments = {"slam", kFirstFrames, "--out", out};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const auto outcome = run_honka(arguments, folder);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.complaints().empty());
  return read_json(folder / out / "summary.json");
}

/// RMS distance from the true positions once laid onto them rigidly.
double slam_error_m(const fs::path& trajectory) {
  auto frames = honka::eval::read_frames_csv(kFirstFrames);
  const FramePoses truth =
      honka::eval::read_chain_poses(kSlamCases / "case0_first_truth.csv.gz", frames);
  const auto poses = honka::eval::read_tum(trajectory);
  REQUIRE(poses.size() == truth.size());
  Eigen::Matrix3Xd from(3, truth.size()), to(3, truth.size());
  for (std::size_t l = 0; l < truth.size(); ++l) {
    CHECK(poses[l].time_s == static_cast<double>(l));
    from.col(static_cast<Eigen::Index>(l)) = poses[l].pose.translation();
    to.col(static_cast<Eigen::Index>(l)) = truth[l].translation();
  }
  const Eigen::Matrix4d T = Eigen::umeyama(from, to, false);
  const Eigen::Matrix3Xd laid =
      (T.topLeftCorner<3, 3>() * from).colwise() + T.topRightCorner<3, 1>();
  return std::sqrt((laid - to).squaredNorm() / static_cast<double>(truth.size()));
}

void write_lines(const fs::path& file, const Words& lines) {
  std::ofstream out(file);
  for (const std::string& line : lines) out << line << '\n';
}

}  // namespace

TEST_CASE("slam: each method writes a trajectory, stems and a summary, the better is better") {
  const TemporaryFolder folder;
  std::map<std::string, double> error_m;
  for (const std::string method : {"chain", "paper", "interpolate", "pose_graph", "landmark_ba"}) {
    INFO(method);
    const Json summary = slam(folder.path(), {"--chain", kFirstChain, "--method", method}, method);
    CHECK(summary["method"] == method);
    CHECK(summary["input"]["frames"] == 120);
    CHECK(summary["metrics"]["blur"]["value"].get<double>() > 0.0);
    CHECK(summary["context"].contains("commit"));
    CHECK(summary["times_s"].contains("total"));
    error_m[method] = slam_error_m(folder.path() / method / "trajectory.tum");
    const auto stems = honka::eval::read_stem_csv(folder.path() / method / "stems.csv");
    CHECK(stems.size() == summary["stems"].get<std::size_t>());
    CHECK(read_text(folder.path() / method / "stems.csv")
              .starts_with("x_m,y_m,z_m,observations,rmse_m\n"));
  }
  CHECK(error_m["chain"] > 0.3);  // one of its steps is lost
  CHECK(error_m["interpolate"] < 0.06);
  CHECK(error_m["pose_graph"] < 0.06);
  CHECK(error_m["landmark_ba"] < 0.03);
}

TEST_CASE("slam: without a chain one is made, twice the same input gives the same files") {
  const TemporaryFolder folder;
  const Json summary = slam(folder.path(), {}, "one");
  CHECK(summary["method"] == "landmark_ba");
  CHECK(summary["input"]["chain"] == "made");
  CHECK(slam_error_m(folder.path() / "one/trajectory.tum") < 0.03);
  slam(folder.path(), {}, "two");
  for (const char* file : {"trajectory.tum", "stems.csv"}) {
    CHECK(read_text(folder.path() / "one" / file) == read_text(folder.path() / "two" / file));
  }
}

TEST_CASE("slam: two vehicles that began apart come into one map") {
  const TemporaryFolder folder;
  // The second half of the drive as another vehicle, which knows only its own first frame.
  const auto frames = honka::eval::read_frames_csv(kFirstFrames);
  Words first = {"frame,x_m,y_m,z_m"}, second = first;
  for (const auto& frame : frames) {
    for (const Eigen::Vector3d& p : frame.points_m) {
      const std::string row = std::to_string(frame.number) + "," + std::to_string(p.x()) + "," +
                              std::to_string(p.y()) + "," + std::to_string(p.z());
      if (frame.number < 70) first.push_back(row);
      if (frame.number >= 50) second.push_back(row);
    }
  }
  write_lines(folder.path() / "first.csv", first);
  write_lines(folder.path() / "second.csv", second);
  const auto outcome =
      run_honka({"slam", "first.csv", "--vehicle", "second.csv", "--out", "map"}, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json summary = read_json(folder.path() / "map/summary.json");
  REQUIRE(summary["vehicles"].size() == 2);
  CHECK(summary["vehicles"][1]["joined"] == true);
  CHECK(summary["vehicles"][1]["joins"].get<int>() >= 2);
  const auto one = honka::eval::read_tum(folder.path() / "map/trajectory.tum");
  const auto two = honka::eval::read_tum(folder.path() / "map/trajectory_2.tum");
  REQUIRE(one.size() == 70);
  REQUIRE(two.size() == 70);
  // Both saw frames 50 to 69: the same places in one map.
  for (std::size_t l = 0; l < 20; ++l) {
    const Pose3 off = one[50 + l].pose.inverse() * two[l].pose;
    CHECK(off.translation().norm() < 0.05);
  }
}

TEST_CASE("slam: gaps in frame numbers, other columns and frames of few stems are answered") {
  const TemporaryFolder folder;
  Words lines = {"id,z,frame,y,x", "# a comment"};
  for (const int frame : {3, 4, 9, 12}) {
    for (int k = 0; k < (frame == 9 ? 1 : 12); ++k) {
      lines.push_back("7,0.5," + std::to_string(frame) + "," + std::to_string(3.0 * (k % 4) - 5.1) +
                      "," + std::to_string(2.7 * k - 11.0 - 0.1 * frame));
    }
  }
  write_lines(folder.path() / "frames.csv", lines);
  const auto outcome = run_honka({"slam", "frames.csv", "--out", "map"}, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json summary = read_json(folder.path() / "map/summary.json");
  CHECK(summary["input"]["frames"] == 4);
  CHECK(summary["frames"]["counts"]["too_few_points"] == 1);
  const auto poses = honka::eval::read_tum(folder.path() / "map/trajectory.tum");
  REQUIRE(poses.size() == 4);
  CHECK(poses[2].time_s == 9.0);
}

TEST_CASE("slam: bad input is one located line and exit code 2") {
  const TemporaryFolder folder;
  const auto refused = [&](const Words& arguments, const Words& parts) {
    Words all = {"slam"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    check_refused(run_honka(all, folder.path()), parts);
    CHECK_FALSE(fs::exists(folder.path() / "map"));
  };
  const auto frames = [&](const Words& lines) {
    write_lines(folder.path() / "frames.csv", lines);
    return Words{"frames.csv", "--out", "map"};
  };
  const Words good = {"frame,x_m,y_m,z_m", "0,1,2,0", "0,4,-3,0", "0,7,1,0", "1,1,2,0"};
  refused(frames({"frame,x_m,y_m,z_m", "0,1,2,nan"}), {"frames.csv:2:", "z_m", "nan"});
  refused(frames({"frame,x_m,y_m,z_m", "0,1,2,3", "0.5,1,2,3"}), {"frames.csv:3:", "0.5"});
  refused(frames({"frame,x_m,y_m", "0,1,2"}), {"frames.csv:1:", "z_m"});
  refused(frames({"frame,x_m,y_m,z_m", "0,1,2"}), {"frames.csv:2:", "3 cells"});
  refused(frames({"frame,x_m,y_m,z_m"}), {"frames.csv", "no stems"});
  refused(frames({}), {"frames.csv", "empty"});
  refused({"absent.csv", "--out", "map"}, {"absent.csv"});
  refused({kFirstFrames, "--out", "map", "--vehicle", "absent.csv"}, {"absent.csv"});
  refused({kFirstFrames, "--out", "map", "--method", "pose_grap"}, {"pose_graph", "did you mean"});
  write_lines(folder.path() / "chain.csv", {"1 0 0 0 0 1 0 0 0 0 1 0"});
  auto with_chain = frames(good);
  with_chain.insert(with_chain.end(), {"--chain", "chain.csv"});
  refused(with_chain, {"chain.csv", "1 poses", "2 frames"});
  write_lines(folder.path() / "chain.csv", {"1 0 0 0 0 1 0 0 0 0 1 0", "9 0 0 0 0 1 0 0 0 0 1 0"});
  refused(with_chain, {"chain.csv:2", "rotation"});
  const std::string packed = read_text(kFirstFrames);
  std::ofstream(folder.path() / "cut.csv.gz", std::ios::binary) << packed.substr(0, 2000);
  refused({"cut.csv.gz", "--out", "map"}, {"cut.csv.gz", "ends too early"});
  std::string hurt = packed;
  for (std::size_t i = 1000; i < 1100; ++i) hurt[i] = static_cast<char>(hurt[i] ^ 0x5a);
  std::ofstream(folder.path() / "hurt.csv.gz", std::ios::binary) << hurt;
  refused({"hurt.csv.gz", "--out", "map"}, {"hurt.csv.gz"});
}

TEST_CASE("slam: a folder that is not ours is left alone, one of ours is replaced as a whole") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "map");
  write_lines(folder.path() / "map/precious.txt", {"mine"});
  check_refused(run_honka({"slam", kFirstFrames, "--out", "map"}, folder.path()), {"map"});
  CHECK(read_text(folder.path() / "map/precious.txt") == "mine\n");
  slam(folder.path(), {"--method", "chain"}, "ours");
  write_lines(folder.path() / "ours/old.txt", {"old"});
  slam(folder.path(), {"--method", "chain"}, "ours");
  CHECK_FALSE(fs::exists(folder.path() / "ours/old.txt"));
  CHECK(contents(folder.path() / "ours").size() == 3);
}
