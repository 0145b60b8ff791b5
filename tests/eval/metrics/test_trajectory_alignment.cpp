#include <catch2/catch.hpp>

#include "eval/metrics/trajectory_errors.h"
#include "tests/eval/metrics/synthetic_poses.h"

using namespace honka;
using namespace honka::eval;
using honka::test::noisy;
using honka::test::winding;

namespace {

constexpr Alignment kSquares[] = {Alignment::kYaw, Alignment::kSe2, Alignment::kSe3,
                                  Alignment::kSim3};

double rmse_m(const PosePairs& pairs) {
  return trajectory_statistics(absolute_errors(pairs).translation_m)->rmse;
}

PosePairs aligned(const PosePairs& pairs, Alignment alignment) {
  const AlignmentResult result = align(pairs, alignment);
  REQUIRE(result.status == AlignmentStatus::kAligned);
  return moved(pairs, result.T_truth_estimate);
}

/// The transform that was put on top of the truth is found, and both errors vanish.
void check_recovered(Alignment alignment, const Similarity3& T_estimate_truth) {
  INFO(alignment_name(alignment));
  const PosePairs pairs = moved(winding(60), T_estimate_truth);
  const AlignmentResult result = align(pairs, alignment);
  REQUIRE(result.status == AlignmentStatus::kAligned);
  CHECK(result.T_truth_estimate.scale * T_estimate_truth.scale == Approx(1.0).epsilon(1e-12));
  CHECK(
      (result.T_truth_estimate.rigid.linear() * T_estimate_truth.rigid.linear()).isIdentity(1e-12));
  const TrajectoryErrors errors = absolute_errors(moved(pairs, result.T_truth_estimate));
  CHECK(trajectory_statistics(errors.translation_m)->max < 1e-8);
  CHECK(trajectory_statistics(errors.rotation_deg)->max < 1e-5);
}

/// Poses along a line, `direction` a step, turning about it.
PosePairs straight(const Eigen::Vector3d& direction) {
  PosePairs pairs;
  for (int i = 0; i < 20; ++i) {
    const Pose3 pose =
        pose_from_rpy(i * direction + Eigen::Vector3d(5e5, 7e6, 100.0), 0.1 * i, 0, 0.3);
    pairs.poses.push_back({0.1 * i, pose, pose});
  }
  return pairs;
}

}  // namespace

TEST_CASE("alignments have names") {
  CHECK(alignment_names().size() == 6);
  for (const std::string& name : alignment_names()) {
    REQUIRE(alignment_of(name));
    CHECK(alignment_name(*alignment_of(name)) == name);
  }
  CHECK_FALSE(alignment_of("SE3"));
  CHECK_FALSE(alignment_of(""));
}

TEST_CASE("known transforms are recovered by every alignment that holds them") {
  const Pose3 shift = pose_from_rpy({12.0, -7.0, 0.0}, 0, 0, 0);
  const Pose3 plan = pose_from_rpy({12.0, -7.0, 0.0}, 0, 0, 2.9);
  const Pose3 lifted = pose_from_rpy({12.0, -7.0, 3.0}, 0, 0, -1.2);
  const Pose3 space = pose_from_rpy({1200.0, -700.0, 40.0}, 0.4, -1.0, 3.0);
  for (const Alignment alignment : kSquares) {
    check_recovered(alignment, {});
    check_recovered(alignment, {1.0, shift});
    check_recovered(alignment, {1.0, plan});
  }
  for (const Alignment alignment :
       {Alignment::kOrigin, Alignment::kYaw, Alignment::kSe3, Alignment::kSim3}) {
    check_recovered(alignment, {1.0, lifted});
  }
  for (const Alignment alignment : {Alignment::kOrigin, Alignment::kSe3, Alignment::kSim3}) {
    check_recovered(alignment, {1.0, space});
  }
  for (const double scale : {0.01, 0.5, 3.0}) check_recovered(Alignment::kSim3, {scale, space});
}

TEST_CASE("what an alignment may not move stays: SE(2) the height, SE(3) the scale") {
  const PosePairs high = moved(winding(60), {1.0, pose_from_rpy({3, 4, 2.5}, 0, 0, 1.0)});
  CHECK(rmse_m(aligned(high, Alignment::kSe2)) == Approx(2.5));
  CHECK(rmse_m(aligned(high, Alignment::kYaw)) < 1e-9);
  const PosePairs large = moved(winding(60), {2.0, Pose3::Identity()});
  CHECK(align(large, Alignment::kSe3).T_truth_estimate.scale == 1.0);
  CHECK(rmse_m(aligned(large, Alignment::kSe3)) > 1.0);
}

TEST_CASE("planar motion is aligned in space, without a reflection") {
  PosePairs pairs = winding(60);
  for (PosePair& pair : pairs.poses) pair.truth.translation().z() = 0.0;
  for (PosePair& pair : pairs.poses) pair.estimate = pair.truth;
  const Pose3 T = pose_from_rpy({1, 2, 3}, 0.5, 0.6, 0.7);
  const AlignmentResult result = align(moved(pairs, {1.0, T}), Alignment::kSe3);
  REQUIRE(result.status == AlignmentStatus::kAligned);
  CHECK(result.T_truth_estimate.rigid.linear().determinant() == Approx(1.0));
  CHECK((result.T_truth_estimate.rigid * T).isApprox(Pose3::Identity(), 1e-12));
}

TEST_CASE("a mirrored path is turned, never mirrored back") {
  PosePairs pairs = winding(60);
  for (PosePair& pair : pairs.poses) pair.estimate.translation().y() *= -1.0;
  for (const Alignment alignment : kSquares) {
    const AlignmentResult result = align(pairs, alignment);
    REQUIRE(result.status == AlignmentStatus::kAligned);
    CHECK(result.T_truth_estimate.rigid.linear().determinant() == Approx(1.0));
    CHECK(result.T_truth_estimate.scale > 0.0);
  }
}

TEST_CASE("no small step away from a least-squares alignment is better") {
  const PosePairs pairs = moved(noisy(80, 0.3, 0.02), {1.3, pose_from_rpy({5, 6, 7}, 0.1, 0.2, 1)});
  for (const Alignment alignment : {Alignment::kSe3, Alignment::kSim3}) {
    const PosePairs best = aligned(pairs, alignment);
    for (int axis = 0; axis < 6; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        const Pose3 step = se3_exp(Twist(sign * 1e-3 * Twist::Unit(axis)));
        CHECK(rmse_m(moved(best, {1.0, step})) > rmse_m(best));
      }
    }
  }
  const PosePairs best = aligned(pairs, Alignment::kSim3);
  CHECK(rmse_m(moved(best, {1.001, Pose3::Identity()})) > rmse_m(best));
  CHECK(rmse_m(moved(best, {0.999, Pose3::Identity()})) > rmse_m(best));
  for (const double sign : {-1.0, 1.0}) {
    const PosePairs yaw = aligned(pairs, Alignment::kYaw);
    CHECK(rmse_m(moved(yaw, {1.0, pose_from_rpy({0, 0, 0}, 0, 0, sign * 1e-3)})) > rmse_m(yaw));
  }
}

TEST_CASE("the scale on a mirrored path is the best one that no mirror needs") {
  PosePairs pairs = noisy(80, 0.3, 0.0);
  for (PosePair& pair : pairs.poses) pair.estimate.translation().z() *= -1.5;
  const PosePairs best = aligned(pairs, Alignment::kSim3);
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  for (const PosePair& pair : best.poses) centre_m += pair.truth.translation() / 80.0;
  for (const double scale : {0.999, 1.001}) {
    Similarity3 step{scale, Pose3::Identity()};
    step.rigid.translation() = (1.0 - scale) * centre_m;
    CHECK(rmse_m(moved(best, step)) > rmse_m(best));
  }
}

TEST_CASE("more freedom fits no worse, and alignment forgets what moved the estimate") {
  const PosePairs pairs = noisy(80, 0.3, 0.02);
  const double none = rmse_m(pairs), se2 = rmse_m(aligned(pairs, Alignment::kSe2)),
               yaw = rmse_m(aligned(pairs, Alignment::kYaw)),
               se3 = rmse_m(aligned(pairs, Alignment::kSe3)),
               sim3 = rmse_m(aligned(pairs, Alignment::kSim3));
  CHECK(none >= se2);
  CHECK(se2 >= yaw);
  CHECK(yaw >= se3);
  CHECK(se3 >= sim3);
  const Pose3 T = pose_from_rpy({100, -50, 20}, 1.0, -0.5, 2.0);
  CHECK(rmse_m(aligned(moved(pairs, {1.0, T}), Alignment::kSe3)) == Approx(se3).epsilon(1e-9));
  CHECK(rmse_m(aligned(moved(pairs, {4.0, T}), Alignment::kSim3)) == Approx(sim3).epsilon(1e-9));
}

TEST_CASE("a straight path leaves the turn about it open, in plan it has a heading") {
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.3, -0.2, 0.05), Eigen::Vector3d(1e-3, 0, 0)}) {
    const PosePairs pairs = straight(direction);
    CHECK(align(pairs, Alignment::kSe3).status == AlignmentStatus::kCollinear);
    CHECK(align(pairs, Alignment::kSim3).status == AlignmentStatus::kCollinear);
    CHECK(rmse_m(aligned(pairs, Alignment::kYaw)) < 1e-6);
    CHECK(rmse_m(aligned(pairs, Alignment::kSe2)) < 1e-6);
  }
  // A centimetre of bend over 19 m is width enough; a climb of 1e5 in 1 still has a heading.
  PosePairs bent = straight({1, 0, 0});
  bent.poses[10].truth.translation().y() += 0.01;
  bent.poses[10].estimate = bent.poses[10].truth;
  CHECK(rmse_m(aligned(bent, Alignment::kSe3)) < 1e-6);
  CHECK(rmse_m(aligned(straight({1e-5, 0, 1}), Alignment::kYaw)) < 1e-6);
  const PosePairs mast = straight({0, 0, 1});
  CHECK(align(mast, Alignment::kYaw).status == AlignmentStatus::kNoExtent);
  CHECK(align(mast, Alignment::kSe2).status == AlignmentStatus::kNoExtent);
  CHECK(align(mast, Alignment::kSe3).status == AlignmentStatus::kCollinear);
  // One crooked side does not define the turn of the other.
  PosePairs half = winding(20);
  for (std::size_t i = 0; i < 20; ++i) half.poses[i].estimate = straight({1, 0, 0}).poses[i].truth;
  CHECK(align(half, Alignment::kSe3).status == AlignmentStatus::kCollinear);
}

TEST_CASE("too little to align on has a status in words, and no transform") {
  const PosePairs still = straight({0, 0, 0});
  PosePairs long_still;
  const Pose3 place = pose_from_rpy({674321.1234, 7123456.789, 101.3}, 0, 0, 0);
  for (int i = 0; i < 1000; ++i) long_still.poses.push_back({1.0 * i, place, place});
  PosePairs one = winding(1), two = winding(2), bare = winding(20);
  bare.truth_has_rotations = false;
  const std::vector<std::pair<AlignmentResult, AlignmentStatus>> cases = {
      {align(still, Alignment::kYaw), AlignmentStatus::kNoExtent},
      {align(still, Alignment::kSe3), AlignmentStatus::kNoExtent},
      {align(still, Alignment::kSim3), AlignmentStatus::kNoExtent},
      {align(long_still, Alignment::kYaw), AlignmentStatus::kNoExtent},
      {align(long_still, Alignment::kSe3), AlignmentStatus::kNoExtent},
      {align(one, Alignment::kSe3), AlignmentStatus::kNoExtent},
      {align(two, Alignment::kSe3), AlignmentStatus::kCollinear},
      {align({}, Alignment::kSe3), AlignmentStatus::kNoPairs},
      {align({}, Alignment::kOrigin), AlignmentStatus::kNoPairs},
      {align(bare, Alignment::kOrigin), AlignmentStatus::kNoRotations},
  };
  for (const auto& [result, status] : cases) {
    CHECK(result.status == status);
    CHECK(alignment_problem(result.status).size() > 10);
    CHECK(result.T_truth_estimate.scale == 1.0);
    CHECK(result.T_truth_estimate.rigid.isApprox(Pose3::Identity(), 0.0));
  }
  CHECK(align(bare, Alignment::kSe3).status == AlignmentStatus::kAligned);
  CHECK(align({}, Alignment::kNone).status == AlignmentStatus::kAligned);
}
