#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/box_counting.h"
#include "algo/slam/map_quality/clusters.h"
#include "algo/slam/map_quality/frame_elimination.h"
#include "algo/slam/map_quality/live_map.h"
#include "algo/types/random.h"

namespace honka {
namespace {

using WorldPoints = std::vector<Eigen::Vector3d>;
constexpr double kNanMetres = std::numeric_limits<double>::quiet_NaN();

WorldPoints scattered_world(int count, double extent_m) {
  RandomStream random(3, "quality_world");
  WorldPoints points;
  for (int k = 0; k < count; ++k) {
    points.emplace_back(random.uniform(0.0, extent_m), random.uniform(0.0, extent_m),
                        random.uniform(0.0, extent_m));
  }
  return points;
}

/// A filled square (or cube) of points `step_m` apart, off the edges of the cells.
WorldPoints filled_world(int side, double step_m, bool spatial) {
  WorldPoints points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < (spatial ? side : 1); ++z) {
        points.emplace_back(0.01 + x * step_m, 0.01 + y * step_m, 0.01 + z * step_m);
      }
    }
  }
  return points;
}

}  // namespace

TEST_CASE("quality: blur of maps known on paper") {
  SECTION("one stem seen many times without noise: one fine cell in one coarse cell") {
    const WorldPoints map_m(20, Eigen::Vector3d(3.0, 4.0, -1.0));
    CHECK(blur(map_m, {}) == Approx(0.2 * 0.2 / (10.0 * 10.0)));
    CHECK(blur(map_m, {0.2, 10.0, true}) == Approx(0.008 / 1000.0));
  }
  SECTION("stems 10 m apart: as many fine cells as coarse ones") {
    WorldPoints map_m;
    for (int x = 0; x < 7; ++x) map_m.emplace_back(10.0 * x, 20.0, 0.0);
    CHECK(blur(map_m, {}) == Approx(0.0004));
  }
  SECTION("everything occupied: 1") {
    // 10 x 10 m from -5 m rounds to one coarse point and to 50 x 50 fine ones.
    WorldPoints map_m;
    for (int x = 0; x < 50; ++x) {
      for (int y = 0; y < 50; ++y) map_m.emplace_back(-4.9 + 0.2 * x, -4.9 + 0.2 * y, 0.0);
    }
    for (Eigen::Vector3d& p : map_m) p.head<2>().array() -= 0.05;
    CHECK(blur(map_m, {}) == Approx(1.0).epsilon(0.05));
  }
  SECTION("rounding is to the nearest: 0.09 and -0.09 m share a point, 0.11 m does not") {
    const WorldPoints map_m = {{0.09, 0.0, 0.0}, {-0.09, 0.0, 0.0}, {0.11, 0.0, 0.0}};
    CHECK(occupied_grid_points(map_m, 0.2) == 2);
  }
  SECTION("heights count in space alone") {
    const WorldPoints map_m = {{0.0, 0.0, 0.0}, {0.0, 0.0, 5.0}};
    CHECK(occupied_grid_points(map_m, 0.2, false) == 1);
    CHECK(occupied_grid_points(map_m, 0.2, true) == 2);
  }
}

TEST_CASE("quality: the bitmap and the sorting count alike") {
  WorldPoints map_m = scattered_world(3000, 20.0);
  for (const bool spatial : {false, true}) {
    for (const double spacing_m : {0.2, 0.7, 3.0}) {
      const auto near = occupied_grid_points(map_m, spacing_m, spatial);
      map_m.emplace_back(4e7, -4e7, 1e7);  // too wide for a bitmap
      CHECK(occupied_grid_points(map_m, spacing_m, spatial) == near + 1);
      map_m.pop_back();
    }
  }
}

TEST_CASE("quality: maps without points, and points that are not finite") {
  CHECK(blur({}, {}) == std::numeric_limits<double>::infinity());
  CHECK(box_dimension({}, {}) == 0.0);
  CHECK(two_scale_dimension({}, 0.2, 10.0) == 0.0);
  CHECK(registration_noise(std::span<const Eigen::Vector3d>{}, {}).clusters == 0);
  WorldPoints map_m = scattered_world(500, 5.0);
  const double clean = blur(map_m, {});
  const RegistrationNoise noise = registration_noise(map_m, {});
  map_m.insert(map_m.begin() + 7, Eigen::Vector3d(kNanMetres, 0.0, 0.0));
  map_m.emplace_back(0.0, std::numeric_limits<double>::infinity(), 0.0);
  map_m.emplace_back(0.0, 0.0, kNanMetres);
  CHECK(blur(map_m, {}) == clean);
  CHECK(registration_noise(map_m, {}).pooled_rmse_m == Approx(noise.pooled_rmse_m));
  CHECK(blur(WorldPoints(4, Eigen::Vector3d::Constant(kNanMetres)), {}) ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("quality: box dimensions known on paper") {
  SECTION("a line has 1") {
    WorldPoints line;
    for (int k = 0; k < 2560; ++k) line.emplace_back(0.01 + 0.02 * k, 0.01, 0.0);
    CHECK(box_dimension(line, {}) == Approx(1.0).margin(0.05));
  }
  SECTION("a filled square has 2, a filled cube 3, less what its faces cut off") {
    CHECK(box_dimension(filled_world(512, 0.1, false), {}) == Approx(2.0).margin(0.05));
    CHECK(box_dimension(filled_world(64, 0.2, true), {0.4, 1.6, true}) == Approx(3.0).margin(0.2));
  }
  SECTION("points far apart have 0") {
    WorldPoints stems;
    for (int k = 0; k < 40; ++k) stems.emplace_back(9.0 * k, 7.0 * (k % 5), 0.0);
    CHECK(box_dimension(stems, {}) == Approx(0.0).margin(1e-12));
  }
  SECTION("two scales: ln(cells) over ln(ratio)") {
    // 50 x 50 fine cells in one coarse cell: ln 2500 / ln 50.
    WorldPoints map_m;
    for (int x = -24; x <= 24; ++x) {
      for (int y = -24; y <= 24; ++y) map_m.emplace_back(0.2 * x, 0.2 * y, 0.0);
    }
    CHECK(two_scale_dimension(map_m, 0.2, 10.0) == Approx(std::log(49.0 * 49.0) / std::log(50.0)));
  }
}

TEST_CASE("quality: clusters known on paper") {
  SECTION("one stem seen 20 times without noise: no error") {
    const auto noise = registration_noise(WorldPoints(20, Eigen::Vector3d(3.0, 4.0, 0.0)), {});
    CHECK(noise.clusters == 1);
    CHECK(noise.mean_rmse_m == Approx(0.0).margin(1e-12));
    CHECK(noise.pooled_rmse_m == Approx(0.0).margin(1e-12));
  }
  SECTION("a stem seen 14 times is none, one seen 15 times is") {
    CHECK(registration_noise(WorldPoints(14, Eigen::Vector3d::Zero()), {}).clusters == 0);
    CHECK(registration_noise(WorldPoints(15, Eigen::Vector3d::Zero()), {}).clusters == 1);
  }
  SECTION("20 points 0.1 m to each side of one stem, 60 at another: mean and pooled differ") {
    WorldPoints map_m;
    for (int k = 0; k < 20; ++k) map_m.emplace_back(k % 2 == 0 ? 0.1 : -0.1, 0.0, 0.3 * k);
    for (int k = 0; k < 60; ++k) map_m.emplace_back(5.0, k % 2 == 0 ? 0.2 : -0.2, 0.0);
    for (const double grid_m : {0.0, 0.05}) {
      const auto noise = registration_noise(map_m, {1.0, 15, grid_m});
      CHECK(noise.clusters == 2);
      CHECK(noise.points == 80);
      CHECK(noise.mean_rmse_m == Approx(0.15));
      CHECK(noise.pooled_rmse_m == Approx(std::sqrt((20 * 0.01 + 60 * 0.04) / 80.0)));
    }
  }
  SECTION("two stems 0.8 m apart are one at a link of 1 m and two at 0.5 m") {
    WorldPoints map_m(20, Eigen::Vector3d(0.0, 0.0, 0.0));
    map_m.insert(map_m.end(), 20, Eigen::Vector3d(0.8, 0.0, 0.0));
    CHECK(registration_noise(map_m, {1.0, 15}).clusters == 1);
    CHECK(registration_noise(map_m, {1.0, 15}).mean_rmse_m == Approx(0.4));
    CHECK(registration_noise(map_m, {0.5, 15}).clusters == 2);
  }
}

TEST_CASE("quality: shares of frames sum to the map's squared error, the worst goes") {
  RandomStream random(5, "quality_frames");
  std::vector<SparseFrame> frames(20);
  FramePoses poses(20, Pose3::Identity());
  for (std::size_t l = 0; l < frames.size(); ++l) {
    frames[l].number = static_cast<std::int64_t>(2 * l);
    for (int stem = 0; stem < 6; ++stem) {
      frames[l].points_m.emplace_back(5.0 * stem + random.normal(0.0, 0.02), 0.0, 0.0);
    }
    frames[l].points_m.emplace_back(100.0 + 10.0 * static_cast<double>(l), 0.0, 0.0);  // no tree
  }
  poses[7].translation() = Eigen::Vector3d(0.0, 0.3, 0.0);
  const FrameShares shares = frame_shares(frames, poses, {});
  double sum = 0.0;
  for (const double w : shares.w_m2) sum += w;
  CHECK(std::sqrt(sum) == Approx(shares.e_c_m).epsilon(1e-12));
  CHECK(shares.points[3] == 6);
  CHECK(worst_frames(shares, 1) == std::vector<std::size_t>{7});
  CHECK(worst_frames(shares, 99).size() == 19);  // the first frame carries the map

  const std::vector<std::size_t> worst = worst_frames(shares, 1);
  remove_frames(frames, poses, worst);
  CHECK(frames.size() == 19);
  CHECK(poses.size() == 19);
  CHECK(frames[7].number == 16);
  CHECK(frame_shares(frames, poses, {}).e_c_m < 0.5 * shares.e_c_m);
  CHECK(worst_frames({}, 3).empty());
}

TEST_CASE("quality: a live map is the map of its poses") {
  std::vector<SparseFrame> frames(5);
  FramePoses poses(5, Pose3::Identity());
  for (std::size_t l = 0; l < frames.size(); ++l) {
    frames[l].points_m = scattered_world(10 * static_cast<int>(l), 8.0);
  }
  LiveMap map(frames, poses, {});
  poses[3].translation().x() = 4.0;
  poses[4].translation().y() = 9.0;
  map.move_after(2, poses);
  const LiveMap fresh(frames, poses, {});
  CHECK(map.blur() == fresh.blur());
  REQUIRE(map.points_m().size() == fresh.points_m().size());
  for (std::size_t p = 0; p < map.points_m().size(); ++p) {
    CHECK(map.points_m()[p] == fresh.points_m()[p]);
  }
}

}  // namespace honka
