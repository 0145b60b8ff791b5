#include <catch2/catch.hpp>

#include "tests/algo/odometry/odometry_drive.h"

using namespace honka;
using namespace honka::stem_world;

// What bad input gets beyond the law of test_odometry_input.cpp.

TEST_CASE("stems input: too few stems are told, and the ground alone is not enough") {
  OdometryUnderTest d("stems");
  d.drive(0, 5);
  const World stems = d.world;
  d.world.trunks.clear();
  for (int i = 5; i < 8; ++i) {
    const OdometryEstimate e = d.at(0.1 * i);
    CHECK(e.status == OdometryStatus::kPredicted);
    CHECK(e.cause == OdometryCause::kFewFeatures);
  }
  d.world = stems;
  d.drive(8, 12);
}

TEST_CASE("stems input: without ground the height is not observed") {
  OdometryUnderTest d("stems");
  d.world.ground = false;
  (void)d.at(0.0);
  const OdometryEstimate e = d.at(0.1);
  CHECK(e.status == OdometryStatus::kDegenerate);
  CHECK(e.cause == OdometryCause::kUnobserved);
  CHECK(e.covariance(2, 2) > 10.0);
}

TEST_CASE("stems input: a jump to a place never seen begins a new map there") {
  OdometryUnderTest d("stems");
  d.drive(0, 10);
  const Way way = d.way;
  d.world = stand(5, 0.0, 77);
  int lost = 0;
  OdometryEstimate e;
  for (int i = 10; i < 20; ++i) {
    e = d.at(0.1 * i);
    lost += e.status == OdometryStatus::kPredicted ? 1 : 0;
  }
  CHECK(lost >= 1);
  CHECK(lost <= 4);
  CHECK(e.status == OdometryStatus::kRegistered);
}
