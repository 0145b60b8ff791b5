#include <catch2/catch.hpp>

#include "algo/slam/chain.h"
#include "tests/algo/slam/core_world.h"
#include "tests/support/slam_case.h"

using namespace honka;

namespace {

/// A drive along an arc through a square of stems, a frame every 0.25 m.
struct ArcDrive {
  std::vector<SparseFrame> frames;
  FramePoses truth;
};

ArcDrive drive_along_arc(std::size_t count, double noise_m) {
  const test::StemPoints stems = test::random_stems(700, 90.0, 21);
  ArcDrive drive;
  const Pose3 start = pose_from_rpy({-10.0, 0.0, 0.0}, 0.0, 0.0, 0.0);
  Pose3 T_first_frame = Pose3::Identity();
  for (std::size_t l = 0; l < count; ++l) {
    drive.truth.push_back(T_first_frame);
    drive.frames.push_back({static_cast<std::int64_t>(3 * l),
                            test::seen_from(stems, start * T_first_frame, noise_m, l)});
    T_first_frame = T_first_frame * pose_from_rpy({0.25, 0.0, 0.0}, 0.0, 0.002, 0.01);
  }
  return drive;
}

}  // namespace

TEST_CASE("A chain over frames without noise is the truth") {
  const ArcDrive drive = drive_along_arc(40, 0.0);
  for (const char* guess : {"identity", "constant_velocity"}) {
    ChainSettings settings;
    settings.inlier_ratio = 0.7;
    settings.guess = guess;
    const Chain chain = make_chain(drive.frames, settings);
    REQUIRE(chain.T_first_frame.size() == 40);
    REQUIRE(chain.steps.size() == 39);
    CHECK(chain.failed_steps() == 0);
    CHECK(chain.T_first_frame[0].matrix() == Pose3::Identity().matrix());
    for (std::size_t l = 0; l < 40; ++l) {
      CHECK(chain.T_first_frame[l].isApprox(drive.truth[l], 1e-9));
    }
  }
}

TEST_CASE("The map, the path and motions between frames") {
  const ArcDrive drive = drive_along_arc(10, 0.0);
  const auto points = map_points(drive.frames, drive.truth);
  std::size_t count = 0;
  for (const SparseFrame& frame : drive.frames) count += frame.points_m.size();
  REQUIRE(points.size() == count);
  CHECK(points[0] == drive.frames[0].points_m[0]);
  CHECK((points.back() - drive.truth.back() * drive.frames.back().points_m.back()).norm() < 1e-12);
  CHECK(path_of(drive.truth)[7] == drive.truth[7].translation());
  const Pose3 T_2_7 = between(drive.truth, 2, 7);
  CHECK((drive.truth[2] * T_2_7).isApprox(drive.truth[7], 1e-12));
}

TEST_CASE("A step that cannot be registered is recorded, and the chain goes on") {
  ArcDrive drive = drive_along_arc(30, 0.02);
  drive.frames[10].points_m.clear();
  drive.frames[20].points_m[5].z() = std::nan("");
  ChainSettings settings;
  settings.inlier_ratio = 0.7;
  for (const char* failed : {"identity", "constant_velocity"}) {
    settings.failed_step = failed;
    const Chain chain = make_chain(drive.frames, settings);
    CHECK(chain.failed_steps() == 4);
    for (const std::size_t step : {9U, 10U}) {
      CHECK(chain.steps[step].status == RegistrationStatus::kTooFewPoints);
    }
    for (const std::size_t step : {19U, 20U}) {
      CHECK(chain.steps[step].status == RegistrationStatus::kNotFinite);
    }
    for (const Pose3& pose : chain.T_first_frame) REQUIRE(pose.matrix().allFinite());
    const double missed_m =
        (chain.T_first_frame[11].translation() - drive.truth[11].translation()).norm();
    if (failed == std::string("identity"))
      CHECK(missed_m > 0.4);
    else
      CHECK(missed_m < 0.2);
  }
}

TEST_CASE("Chains of no frame, of one, and of empty frames") {
  CHECK(make_chain({}, {}).T_first_frame.empty());
  const std::vector<SparseFrame> empty(5);
  const Chain chain = make_chain(empty, {});
  CHECK(chain.failed_steps() == 4);
  for (const Pose3& pose : chain.T_first_frame) CHECK(pose.isApprox(Pose3::Identity()));
  CHECK(make_chain(std::span(empty).first(1), {}).steps.empty());
}

TEST_CASE("The chain of the reference case, step for step") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("skipped: the shared SLAM cases are not there");
    return;
  }
  std::vector<SparseFrame> frames;
  for (auto& points : test::read_frame_points(*folder / "case0_points.csv.gz")) {
    frames.push_back({static_cast<std::int64_t>(frames.size()), std::move(points)});
  }
  ChainSettings settings;
  settings.inlier_ratio = 0.4;
  const Chain chain = make_chain(frames, settings);
  const auto reference = test::read_pose_rows(*folder / "case0_chain_pose.csv");
  REQUIRE(chain.T_first_frame.size() == reference.size());
  for (std::size_t l = 0; l < reference.size(); ++l) {
    INFO("frame " << l);
    REQUIRE((chain.T_first_frame[l].matrix() - reference[l].matrix()).norm() < 1e-4);
  }
}
