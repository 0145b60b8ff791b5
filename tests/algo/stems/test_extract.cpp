#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "algo/stems/extract.h"
#include "algo/types/pose.h"
#include "algo/types/user_error.h"
#include "tests/algo/stems/analytic.h"

using namespace honka;
using namespace honka::analytic;

namespace {

const ObservedStem* nearest(const std::vector<ObservedStem>& stems, const Eigen::Vector2d& at) {
  const ObservedStem* best = nullptr;
  for (const ObservedStem& s : stems) {
    if (best == nullptr || (s.position_m - at).norm() < (best->position_m - at).norm()) best = &s;
  }
  return best;
}

LocalCloud moved(const LocalCloud& cloud, const Pose3& T) {
  LocalCloud other = cloud;
  for (auto& p : other.points_m) p = T * p;
  for (auto& p : other.origins_m) p = T * p;
  return other;
}

std::vector<StemSettings> all_variants() {
  std::vector<StemSettings> variants;
  for (const char* form : {"journal", "preprint"}) {
    for (const char* search : {"kd_tree", "voxel_hash"}) {
      for (const char* centre : {"mean", "bias_corrected", "circle_fit"}) {
        for (const bool band : {false, true}) {
          StemSettings s;
          s.form = form, s.search = search, s.centre = centre, s.height_band = band;
          variants.push_back(s);
        }
      }
    }
  }
  return variants;
}

}  // namespace

TEST_CASE("every variant finds the stems of a stand and nothing else") {
  std::vector<Eigen::Vector2d> centres;
  const LocalCloud cloud = stand(centres);
  for (const StemSettings& s : all_variants()) {
    INFO(s.form << ' ' << s.search << ' ' << s.centre << " band " << s.height_band);
    const StemExtraction found = extract_stems(cloud, s);
    REQUIRE(found.stems.size() == centres.size());
    for (const Eigen::Vector2d& centre : centres) {
      const double error_m = (nearest(found.stems, centre)->position_m - centre).norm();
      CHECK(error_m < (s.centre == "mean" ? 0.11 : 0.03));
    }
  }
}

TEST_CASE("the mean lies 0.785 r towards the sensor, the other centres do not") {
  const Eigen::Vector2d centre(8.0, 5.0);
  const Eigen::Vector2d ray = centre.normalized();
  for (const double radius : {0.08, 0.15, 0.3}) {
    LocalCloud cloud = cloud_from({0.0, 0.0, 2.0});
    add_cylinder(cloud, centre, radius, 40, 36);
    StemSettings s;
    const auto mean = extract_stems(cloud, s).stems;
    REQUIRE(mean.size() == 1);
    const Eigen::Vector2d error = mean[0].position_m - centre;
    CHECK(error.dot(ray) == Approx(-kPi / 4.0 * radius).epsilon(0.01));
    CHECK(ray.x() * error.y() - ray.y() * error.x() == Approx(0.0).margin(1e-9));
    s.centre = "bias_corrected";
    CHECK((extract_stems(cloud, s).stems[0].position_m - centre).norm() < 0.03 * radius);
    s.centre = "circle_fit";
    const auto fit = extract_stems(cloud, s).stems;
    CHECK((fit[0].position_m - centre).norm() < 1e-6);
    REQUIRE(fit[0].dbh_m.has_value());
    CHECK(*fit[0].dbh_m == Approx(2.0 * radius).epsilon(1e-5));
  }
}

TEST_CASE("a stem shorter than the offset is no stem") {
  LocalCloud cloud = cloud_from({0.0, 0.0, 2.0});
  add_cylinder(cloud, {5.0, 0.0}, 0.1, 8, 12);  // 0.05–1.425 m
  for (const char* search : {"kd_tree", "voxel_hash"}) {
    StemSettings s;
    s.search = search;
    CHECK(extract_stems(cloud, s).stems.empty());
    s.height_offset_m = 1.0;
    CHECK(extract_stems(cloud, s).stems.size() == 1);
  }
}

TEST_CASE("thresholds are strict, as printed") {
  LocalCloud cloud = cloud_from(Eigen::Vector3d::Zero());
  for (int k = 0; k < 6; ++k) add_point(cloud, {5.0 + k / 64.0, 0.0, 0.0});
  for (int k = 0; k < 6; ++k) add_point(cloud, {5.0 + k / 64.0, 0.0, 2.25});
  StemSettings s;
  s.cluster_threshold = 6;
  for (const char* search : {"kd_tree", "voxel_hash"}) {
    s.search = search;
    s.d_threshold_m = 0.25;
    CHECK(extract_stems(cloud, s).stems.empty());
    s.d_threshold_m = 0.2500001;
    CHECK(extract_stems(cloud, s).stems.size() == 1);
  }
  s.cluster_threshold = 7;
  CHECK(extract_stems(cloud, s).stems.empty());
}

TEST_CASE("a stem is seen at least so often a sweep") {
  LocalCloud cloud = cloud_from(Eigen::Vector3d::Zero());
  for (int k = 0; k < 6; ++k) add_point(cloud, {5.0 + k / 64.0, 0.0, 0.0});
  for (int k = 0; k < 6; ++k) add_point(cloud, {5.0 + k / 64.0, 0.0, 2.0});
  cloud.origins_m.resize(4, Eigen::Vector3d::Zero());
  StemSettings s;  // 6 lower points pass the 2 m test: 1.5 a sweep
  CHECK(extract_stems(cloud, s).stems.size() == 1);
  cloud.origins_m.resize(5, Eigen::Vector3d::Zero());
  CHECK(extract_stems(cloud, s).stems.empty());
  s.points_per_sweep = 0.0;
  CHECK(extract_stems(cloud, s).stems.size() == 1);
}

TEST_CASE("kd_tree and voxel_hash give the same stems and stages") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    LocalCloud cloud = random_cloud(seed, 3000, seed % 2 == 0 ? 2.0 : 6.0);
    std::vector<Eigen::Vector2d> centres;
    if (seed % 3 == 0) cloud = stand(centres);
    for (StemSettings s : all_variants()) {
      if (s.search != "kd_tree") continue;
      if (seed % 4 == 1) s.d_threshold_m = 0.15, s.cluster_link_m = 0.08;
      const StemExtraction literal = extract_stems(cloud, s);
      s.search = "voxel_hash";
      const StemExtraction quick = extract_stems(cloud, s);
      CHECK(literal.stages == quick.stages);
      REQUIRE(literal.stems.size() == quick.stems.size());
      for (std::size_t i = 0; i < literal.stems.size(); ++i) {
        CHECK(literal.stems[i].position_m == quick.stems[i].position_m);
        CHECK(literal.stems[i].points == quick.stems[i].points);
        CHECK(literal.stems[i].dbh_m == quick.stems[i].dbh_m);
      }
    }
  }
}

TEST_CASE("stems turn and move with the cloud") {
  std::vector<Eigen::Vector2d> centres;
  const LocalCloud cloud = stand(centres);
  const Pose3 T = pose_from_rpy({1234.5, -987.6, 12.0}, 0.0, 0.0, 2.1);
  for (const StemSettings& s : all_variants()) {
    if (s.height_band) continue;  // its grid is tied to the axes
    INFO(s.form << ' ' << s.search << ' ' << s.centre);
    const auto here = extract_stems(cloud, s).stems;
    const auto there = extract_stems(moved(cloud, T), s).stems;
    REQUIRE(here.size() == there.size());
    for (const ObservedStem& stem : here) {
      const Eigen::Vector2d expected = planar(T) * stem.position_m;
      CHECK((nearest(there, expected)->position_m - expected).norm() < 1e-6);
    }
  }
}

TEST_CASE("the order of the points does not matter") {
  std::vector<Eigen::Vector2d> centres;
  const LocalCloud cloud = stand(centres);
  LocalCloud shuffled = cloud;
  RandomStream random(7, "shuffle");
  for (std::size_t i = shuffled.size() - 1; i > 0; --i) {
    std::swap(shuffled.points_m[i], shuffled.points_m[random.below(i + 1)]);
  }
  for (const StemSettings& s : all_variants()) {
    const auto a = extract_stems(cloud, s).stems;
    const auto b = extract_stems(shuffled, s).stems;
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK((a[i].position_m - b[i].position_m).norm() < 1e-9);
    }
  }
}

TEST_CASE("empty clouds, single points and bad input") {
  for (const StemSettings& s : all_variants()) {
    CHECK(extract_stems({}, s).stems.empty());
    LocalCloud one = cloud_from(Eigen::Vector3d::Zero());
    add_point(one, {1.0, 2.0, 3.0});
    CHECK(extract_stems(one, s).stems.empty());
    one.points_m[0].y() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(extract_stems(one, s), UserError);
  }
  StemSettings s;
  s.form = "newspaper";
  CHECK_THROWS_WITH(extract_stems({}, s), Catch::Contains("journal | preprint"));
}

TEST_CASE("points beyond the range and second points of a voxel are left out") {
  LocalCloud cloud = cloud_from({0.0, 0.0, 2.0});
  add_cylinder(cloud, {10.0, 0.0}, 0.1, 12, 44);
  add_cylinder(cloud, {45.0, 0.0}, 0.1, 12, 44);
  StemSettings s;
  CHECK(extract_stems(cloud, s).stems.size() == 1);
  s.max_range_m = 60.0;
  CHECK(extract_stems(cloud, s).stems.size() == 2);
  const LocalCloud once = cloud;
  cloud.points_m.insert(cloud.points_m.end(), once.points_m.begin(), once.points_m.end());
  cloud.frames.insert(cloud.frames.end(), once.frames.begin(), once.frames.end());
  s.voxel_m = 0.001;
  CHECK(extract_stems(cloud, s).stems[0].points == extract_stems(once, s).stems[0].points);
}

TEST_CASE("the height band copes with undergrowth and gives the ground") {
  std::vector<Eigen::Vector2d> centres;
  LocalCloud cloud = stand(centres);
  // A canopy above bushes: 2 m pairs, though no stem. The band leaves the canopy out.
  RandomStream random(3, "bushes");
  for (int i = 0; i < 600; ++i) {
    const double x = 2.0 + random.uniform(), y = 2.0 + random.uniform();
    add_point(cloud, {x, y, random.uniform(6.5, 7.0)});
    add_point(cloud, {x, y, random.uniform(8.5, 9.0)});
  }
  StemSettings s;
  CHECK(extract_stems(cloud, s).stems.size() > centres.size());
  s.height_band = true;
  const auto stems = extract_stems(cloud, s).stems;
  CHECK(stems.size() == centres.size());
  for (const ObservedStem& stem : stems) CHECK(stem.z_m == Approx(0.0).margin(0.05));
}

TEST_CASE("stages tell Figure 5's three kinds of point") {
  std::vector<Eigen::Vector2d> centres;
  const LocalCloud cloud = stand(centres);
  StemSettings s;
  s.cluster_threshold = 1;
  const auto all = extract_stems(cloud, s);
  s.cluster_threshold = 100000;
  const auto none = extract_stems(cloud, s);
  const auto count = [](const StemExtraction& e, PointStage stage) {
    return std::count(e.stages.begin(), e.stages.end(), stage);
  };
  CHECK(all.stages.size() == cloud.size());
  CHECK(count(all, PointStage::kTrunkCandidate) == 0);
  CHECK(count(none, PointStage::kClustered) == 0);
  CHECK(count(all, PointStage::kClustered) == count(none, PointStage::kTrunkCandidate));
  CHECK(count(all, PointStage::kDropped) > 25000);  // the ground
}
