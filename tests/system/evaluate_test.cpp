// honka evaluate: the published figures of fr1_xyz, small trajectories known by hand, bad input.
#include <cmath>

#include "eval/io/kitti.h"
#include "eval/io/tum.h"
#include "eval/metrics/trajectory_errors.h"
#include "tests/system/program.h"

namespace {

using honka::Pose3;
using honka::pose_from_rpy;
using honka::eval::TimedPose;
using honka::test::check_refused;
using honka::test::Json;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
namespace fs = std::filesystem;

using Words = std::vector<std::string>;

Json evaluate(const fs::path& folder, const Words& options, const std::string& truth = "truth.tum",
              const std::string& estimate = "estimate.tum") {
  Words arguments = {"evaluate", truth, estimate, "--json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const auto outcome = run_honka(arguments, folder);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  return Json::parse(outcome.out);
}

double rmse(const Json& errors, const char* kind) { return errors[kind]["rmse"].get<double>(); }

/// A bent drive at 10 Hz.
std::vector<TimedPose> drive(std::size_t poses = 100) {
  std::vector<TimedPose> result;
  for (std::size_t i = 0; i < poses; ++i) {
    const double s = 0.1 * static_cast<double>(i);
    result.push_back({s, pose_from_rpy({s, std::sin(s), 0.1 * s * s}, 0.0, 0.1, 0.3 * s)});
  }
  return result;
}

std::vector<TimedPose> moved(std::vector<TimedPose> poses, const Pose3& T) {
  for (TimedPose& pose : poses) pose.pose = T * pose.pose;
  return poses;
}

void write_positions(const fs::path& file, const std::vector<TimedPose>& poses) {
  std::ofstream out(file);
  out.precision(17);
  for (const TimedPose& pose : poses) {
    out << pose.time_s << ' ' << pose.pose.translation().transpose() << '\n';
  }
}

const fs::path kShared = honka::test::shared("data/trajectories");
const std::string kTruth = (kShared / "freiburg1_xyz-groundtruth.txt").string();
const std::string kEstimate = (kShared / "freiburg1_xyz-rgbdslam.txt").string();

bool skipped() {
  if (fs::exists(kShared)) return false;
  WARN("skipped: " << kShared << " is absent");
  return true;
}

}  // namespace

TEST_CASE("the published errors of RGB-D SLAM on fr1_xyz") {
  if (skipped()) return;
  const TemporaryFolder folder;
  const Json json = evaluate(folder.path(), {"--align", "se3", "--delta", "1s"}, kTruth, kEstimate);
  CHECK(json["associated"] == 786);
  CHECK(json["reference_poses"] == 3000);
  CHECK(json["estimate_poses"] == 788);
  const std::vector<std::pair<const char*, double>> kApe_m = {
      {"rmse", 0.013473}, {"mean", 0.012029}, {"median", 0.011176},
      {"std", 0.006068},  {"min", 0.000939},  {"max", 0.034727}};
  for (const auto& [statistic, value_m] : kApe_m) {
    INFO(statistic);
    CHECK(json["ape"]["translation_m"][statistic].get<double>() == Approx(value_m).margin(1e-6));
  }
  CHECK(json["rpe"]["pairs"] == 753);
  CHECK(rmse(json["rpe"], "translation_m") == Approx(0.021554).margin(1e-6));
  CHECK(rmse(json["rpe"], "rotation_deg") == Approx(0.934480).margin(1e-6));
  // The relative error needs no alignment.
  const Json raw = evaluate(folder.path(), {}, kTruth, kEstimate);
  CHECK(rmse(raw["rpe"], "translation_m") == Approx(rmse(json["rpe"], "translation_m")));
  const Json tight = evaluate(folder.path(), {"--max-time-difference", "0.01"}, kTruth, kEstimate);
  CHECK(tight["associated"] == 785);
}

TEST_CASE("the backward motion gives the figure of Sturm's script") {
  if (skipped()) return;
  using namespace honka::eval;
  const auto truth = read_tum(kTruth), estimate = read_tum(kEstimate);
  const auto times = [](const std::vector<TimedPose>& poses) {
    std::vector<double> result;
    for (const TimedPose& pose : poses) result.push_back(pose.time_s);
    return result;
  };
  PosePairs pairs;
  pairs.estimate_times_s = times(estimate);
  for (const auto& pair : associate_times(times(truth), pairs.estimate_times_s, 0.02)) {
    const TimedPose& estimated = estimate[pair.estimate];
    pairs.poses.push_back({estimated.time_s, truth[pair.truth].pose, estimated.pose});
  }
  auto motions = honka::eval::motions(pairs, {});
  for (Motion& motion : motions) std::swap(motion.from, motion.to);
  const auto errors = relative_errors(pairs, motions);
  CHECK(trajectory_statistics(errors.translation_m)->rmse == Approx(0.021217).margin(1e-6));
}

TEST_CASE("evaluate has the keys of the interface, in order") {
  const TemporaryFolder folder;
  honka::eval::write_tum(folder / "truth.tum", drive());
  honka::eval::write_tum(folder / "estimate.tum", drive());
  const Json json = evaluate(folder.path(), {});
  using honka::test::keys;
  CHECK(keys(json) ==
        Words{"align", "associated", "reference_poses", "estimate_poses", "ape", "rpe"});
  CHECK(keys(json["ape"]) == Words{"translation_m", "rotation_deg"});
  CHECK(keys(json["rpe"]) == Words{"delta", "unit", "pairs", "translation_m", "rotation_deg"});
  for (const char* errors : {"ape", "rpe"}) {
    for (const char* kind : {"translation_m", "rotation_deg"}) {
      CHECK(keys(json[errors][kind]) ==
            Words{"rmse", "mean", "median", "std", "min", "max", "sse"});
      CHECK(rmse(json[errors], kind) < 1e-5);
    }
  }
  CHECK(json["align"] == "none");
  CHECK(json["rpe"]["delta"] == 1.0);
  CHECK(json["rpe"]["unit"] == "s");
  CHECK(json["rpe"]["pairs"] == 89);
}

TEST_CASE("each alignment takes away what it may move") {
  const TemporaryFolder folder;
  const auto ape_m = [&](const Pose3& T, double scale, const std::string& align) {
    auto poses = moved(drive(), T);
    for (TimedPose& pose : poses) pose.pose.translation() *= scale;
    honka::eval::write_tum(folder / "truth.tum", drive());
    honka::eval::write_tum(folder / "estimate.tum", poses);
    const Json json = evaluate(folder.path(), {"--align", align});
    CHECK(json["align"] == align);
    return rmse(json["ape"], "translation_m");
  };
  const Pose3 plan = pose_from_rpy({30, 40, 0}, 0, 0, 1),
              lifted = pose_from_rpy({3, 4, 5}, 0, 0, 1),
              space = pose_from_rpy({3, 4, 5}, 0.3, 0.2, 1);
  CHECK(ape_m(pose_from_rpy({30, 40, 0}, 0, 0, 0), 1, "none") == Approx(50.0));
  CHECK(ape_m(plan, 1, "se2") < 1e-8);
  CHECK(ape_m(lifted, 1, "se2") == Approx(5.0));
  CHECK(ape_m(lifted, 1, "yaw") < 1e-8);
  CHECK(ape_m(space, 1, "yaw") > 0.1);
  for (const char* align : {"origin", "se3", "sim3"}) CHECK(ape_m(space, 1, align) < 1e-8);
  CHECK(ape_m(space, 2, "se3") > 0.1);
  CHECK(ape_m(space, 2, "sim3") < 1e-8);
}

TEST_CASE("truth of positions alone: translation errors, no rotation errors") {
  const TemporaryFolder folder;
  write_positions(folder / "truth.tum", drive());
  honka::eval::write_tum(folder / "estimate.tum",
                         moved(drive(), pose_from_rpy({3, 4, 5}, 0.3, 0.2, 1)));
  for (const char* align : {"se3", "sim3"}) {
    const Json json = evaluate(folder.path(), {"--align", align});
    CHECK(rmse(json["ape"], "translation_m") < 1e-8);
    CHECK(rmse(json["rpe"], "translation_m") < 1e-8);
    CHECK(json["ape"]["rotation_deg"].is_null());
    CHECK(json["rpe"]["rotation_deg"].is_null());
    CHECK(json["rpe"]["pairs"] == 89);
  }
  check_refused(
      run_honka({"evaluate", "truth.tum", "estimate.tum", "--align", "origin"}, folder.path()),
      {"estimate.tum: --align origin is not defined", "positions alone"});
  const auto text = run_honka({"evaluate", "truth.tum", "estimate.tum"}, folder.path());
  CHECK_THAT(text.out, Catch::Contains("RPE rotation (deg)       none"));
}

TEST_CASE("KITTI rows pair by number, their motions are frames or metres") {
  const TemporaryFolder folder;
  std::vector<Pose3> truth, estimate;
  for (const TimedPose& pose : drive(50)) {
    truth.push_back(pose.pose);
    estimate.push_back(pose.pose * pose_from_rpy({0.5, 0, 0}, 0, 0, 0));
  }
  honka::eval::write_kitti(folder / "truth.txt", truth);
  honka::eval::write_kitti(folder / "estimate.txt", estimate);
  const auto kitti = [&](Words options) {
    options.insert(options.end(), {"--format", "kitti"});
    return evaluate(folder.path(), options, "truth.txt", "estimate.txt");
  };
  const Json json = kitti({});
  CHECK(json["associated"] == 50);
  CHECK(rmse(json["ape"], "translation_m") == Approx(0.5));
  CHECK(json["rpe"]["unit"] == "f");
  CHECK(json["rpe"]["pairs"] == 49);
  CHECK(kitti({"--delta", "10f"})["rpe"]["pairs"] == 4);
  CHECK(kitti({"--delta", "10f", "--all-pairs"})["rpe"]["pairs"] == 40);
  CHECK(kitti({"--delta", "1m"})["rpe"]["unit"] == "m");
  const auto refused = [&](const Words& options, const Words& parts) {
    Words words = {"evaluate", "truth.txt", "estimate.txt", "--format", "kitti"};
    words.insert(words.end(), options.begin(), options.end());
    check_refused(run_honka(words, folder.path()), parts);
  };
  refused({"--delta", "1s"}, {"--delta: '1s'", "KITTI"});
  estimate.pop_back();
  honka::eval::write_kitti(folder / "estimate.txt", estimate);
  refused({}, {"estimate.txt: 49 rows", "truth.txt has 50"});
  write_raw(folder / "estimate.txt", "1 2 3\n");
  refused({}, {"estimate.txt:1:1: 3 numbers"});
}

TEST_CASE("motions longer than the trajectory: no pairs, no figures, and still an answer") {
  const TemporaryFolder folder;
  honka::eval::write_tum(folder / "truth.tum", drive());
  honka::eval::write_tum(folder / "estimate.tum", drive());
  for (const char* delta : {"100s", "1000m", "100f"}) {
    const Json json = evaluate(folder.path(), {"--delta", delta});
    CHECK(json["rpe"]["pairs"] == 0);
    CHECK(json["rpe"]["translation_m"].is_null());
    CHECK(json["ape"]["translation_m"].is_object());
  }
}

TEST_CASE("bad trajectories and options are refused with one line") {
  const TemporaryFolder folder;
  honka::eval::write_tum(folder / "truth.tum", drive());
  const auto refused = [&](const std::string& estimate, const Words& options, const Words& parts) {
    write_raw(folder / "estimate.tum", estimate);
    Words words = {"evaluate", "truth.tum", "estimate.tum"};
    words.insert(words.end(), options.begin(), options.end());
    check_refused(run_honka(words, folder.path()), parts);
  };
  const std::string kRow = " 0 0 0 0 0 0 1\n";
  const std::string kGood = "0" + kRow + "0.1" + kRow;
  refused("1" + kRow + "0.5" + kRow, {}, {"estimate.tum:2:1: time 0.5 does not follow"});
  refused("1" + kRow + "1" + kRow, {}, {"estimate.tum:2:1: time 1 does not follow"});
  refused("", {}, {"estimate.tum: no poses"});
  refused("0 1 2\n", {}, {"estimate.tum:1:1: 3 numbers"});
  refused("0 nan 0 0 0 0 0 1\n", {}, {"estimate.tum:1:3: ", "not finite"});
  refused("0 1e200 0 0 0 0 0 1\n" + ("1" + kRow), {}, {"estimate.tum: ", "beyond 1e9 m"});
  refused("900" + kRow + "901" + kRow, {}, {"estimate.tum: none of its times (900 to 901 s)"});
  refused("0" + kRow, {}, {"estimate.tum: only one pose"});
  refused(kGood, {"--align", "se3"}, {"--align se3 is not defined", "no extent"});
  refused("0 0 0 0 0 0 0 1\n0.1 1 0 0 0 0 0 1\n", {"--align", "se3"}, {"se3", "on a line"});
  refused(kGood, {"--align", "SE3"}, {"--align: unknown 'SE3'", "se3"});
  refused(kGood, {"--format", "euroc"}, {"--format: euroc"});
  refused(kGood, {"--max-time-difference", "-1"}, {"--max-time-difference: "});
  refused(kGood, {"--max-time-difference", "nan"}, {"--max-time-difference: "});
  for (const char* delta : {"1", "s", "-1s", "0m", "1.5f", "nans", "infm", "1e999s", "1 s", "1x"}) {
    refused(kGood, {std::string("--delta=") + delta},
            {std::string("--delta: '") + delta + "'", "such as 1s, 10m or 1f"});
  }
  check_refused(run_honka({"evaluate", "none.tum", "truth.tum"}, folder.path()),
                {"none.tum: no such file"});
}
