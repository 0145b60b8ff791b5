// honka simulate, then honka score with poses made from the recording's own truth.
#include "eval/io/recording.h"

#include "eval/io/csv.h"
#include "eval/io/tum.h"
#include "tests/system/program.h"

namespace {

using honka::Pose3;
using honka::eval::RecordingReader;
using honka::eval::TimedPose;
using honka::test::Json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_tiny;

void simulate(const TemporaryFolder& folder, const std::string& out, const std::string& threads) {
  write_tiny(folder);
  const auto outcome = run_honka({"simulate", "tiny.toml", "--out", out, "--threads", threads, "-s",
                                  "simulate.start_s=2", "-s", "simulate.duration_s=2.5"},
                                 folder.path());
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, Catch::Contains(out + ": 25 sweeps"));
}

std::vector<TimedPose> truth_of(const RecordingReader& recording) {
  std::vector<TimedPose> poses;
  for (std::size_t i = 0; i < recording.sweeps(); ++i) {
    const auto knots = recording.poses(i);
    // Every third knot; the last of a sweep stands again as the first of the next.
    for (std::size_t k = 0; k + 1 < knots.times_s.size(); k += 3) {
      poses.push_back({knots.times_s[k], knots.T_world_lidar[k]});
    }
  }
  return poses;
}

Json score(const TemporaryFolder& folder, const std::vector<TimedPose>& poses,
           const std::vector<std::string>& more = {}) {
  honka::eval::write_tum(folder / "poses.tum", poses);
  std::vector<std::string> arguments = {"score", "drive.h5", "poses.tum"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto outcome = run_honka(arguments, folder.path());
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

double figure(const Json& errors, const char* what, const char* statistic) {
  return errors[what][statistic].get<double>();
}

}  // namespace

TEST_CASE("truth scores 0, a known offset scores that offset") {
  const TemporaryFolder folder;
  simulate(folder, "drive.h5", "2");
  const RecordingReader recording(folder / "drive.h5");
  CHECK(recording.sweeps() == 25);
  const auto truth = truth_of(recording);

  SECTION("truth") {
    const Json json = score(folder, truth);
    CHECK(json["associated"] == truth.size());
    CHECK(json["estimate_poses"] == truth.size());
    CHECK(figure(json["ape"], "translation_m", "max") < 1e-9);
    CHECK(figure(json["ape"], "rotation_deg", "max") < 1e-5);
    CHECK(honka::test::keys(json["ape"]["translation_m"]) ==
          std::vector<std::string>{"rmse", "mean", "median", "std", "min", "max", "sse"});
  }
  SECTION("an offset that alignment takes away") {
    const Pose3 T_offset = honka::pose_from_rpy({3.0, 4.0, 0.0}, 0, 0, 0.1);
    auto poses = truth;
    for (TimedPose& pose : poses) {
      pose.pose.translation() += Eigen::Vector3d(3.0, 4.0, 0.0);
    }
    const Json moved = score(folder, poses);
    CHECK(figure(moved["ape"], "translation_m", "min") == Approx(5.0).margin(1e-8));
    CHECK(figure(moved["ape"], "translation_m", "max") == Approx(5.0).margin(1e-8));
    CHECK(figure(moved["ape_se3"], "translation_m", "rmse") < 1e-8);
    poses = truth;
    for (TimedPose& pose : poses) pose.pose = T_offset * pose.pose;
    const Json turned = score(folder, poses);
    CHECK(figure(turned["ape"], "rotation_deg", "mean") ==
          Approx(honka::rad_to_deg(0.1)).margin(1e-6));
    CHECK(figure(turned["ape_se3"], "translation_m", "max") < 1e-7);
  }
  SECTION("poses between knots and outside the recording") {
    const auto middle = [](const TimedPose& a, const TimedPose& b) {
      TimedPose m = a;
      m.time_s = 0.5 * (a.time_s + b.time_s);
      m.pose.translation() = 0.5 * (a.pose.translation() + b.pose.translation());
      return m;
    };
    const Json json = score(folder, {{0.0, truth[0].pose},
                                     middle(truth[30], truth[31]),
                                     middle(truth[60], truth[61]),
                                     {1e4, truth[0].pose}});
    CHECK(json["estimate_poses"] == 4);
    CHECK(json["associated"] == 2);
    CHECK(json["ape_se3"].is_null());
    CHECK(figure(json["ape"], "translation_m", "max") < 2e-3);
  }
  SECTION("stems") {
    auto stems = recording.stems().stems_in_world;
    const auto trees = stems.size();
    for (auto& stem : stems) stem.position_m.x() += 0.1;
    stems.resize(trees / 2);
    honka::eval::write_stem_csv(folder / "stems.csv", stems);
    const Json json = score(folder, truth, {"stems.csv"})["stems"];
    CHECK(json["found"] == trees / 2);
    CHECK(json["trees"] == trees);
    CHECK(json["precision"] == 1.0);
    CHECK(json["recall"].get<double>() ==
          Approx(static_cast<double>(trees / 2) / static_cast<double>(trees)));
    CHECK(json["position_rmse_m"].get<double>() == Approx(0.1));
  }
}

TEST_CASE("a recording has the same scans and truth whatever the threads") {
  const TemporaryFolder folder;
  simulate(folder, "one.h5", "1");
  simulate(folder, "two.h5", "2");
  const RecordingReader one(folder / "one.h5"), two(folder / "two.h5");
  REQUIRE(one.sweeps() == two.sweeps());
  for (std::size_t i = 0; i < one.sweeps(); ++i) {
    CHECK((one.sweep(i).returns == two.sweep(i).returns));
    CHECK(one.sweep(i).index == two.sweep(i).index);
    CHECK(one.poses(i).times_s == two.poses(i).times_s);
    CHECK(one.poses(i).T_world_lidar[3].matrix() == two.poses(i).T_world_lidar[3].matrix());
  }
  CHECK((one.stems() == two.stems()));
  CHECK(folder.entries() == 3);
}
