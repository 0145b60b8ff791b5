#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/box_counting.h"
#include "algo/slam/map_quality/clusters.h"
#include "tests/support/slam_case.h"

namespace honka {
namespace {

using QualityMap = std::vector<Eigen::Vector3d>;

QualityMap case0_map(const std::filesystem::path& folder, const std::string& poses_file) {
  const auto frames = test::read_frame_points(folder / "case0_points.csv.gz");
  const auto poses = test::read_pose_rows(folder / poses_file);
  QualityMap map_m;
  for (std::size_t l = 0; l < frames.size(); ++l) {
    for (const Eigen::Vector3d& p : frames[l]) map_m.push_back(poses[l] * p);
  }
  return map_m;
}

nlohmann::json quality_reference(const std::filesystem::path& folder) {
  std::ifstream stream(folder / "case0_reference.json");
  return nlohmann::json::parse(stream);
}

/// `tolerance` is for what hangs on single cells: the points are stored to a micrometre, and a
/// point that this moves over the edge of a cell of its own changes the count by one.
void check_sharpness(const QualityMap& map_m, const nlohmann::json& row, double tolerance) {
  CHECK(blur(map_m, {}) == Approx(row["beta"].get<double>()).epsilon(tolerance));
  CHECK(box_dimension(map_m, {}) == Approx(row["dim"].get<double>()).epsilon(tolerance));
  CHECK(two_scale_dimension(map_m, 0.2, 10.0) ==
        Approx(row["dim2"].get<double>()).epsilon(tolerance));
}

void check_noise(const QualityMap& map_m, const nlohmann::json& row, double tolerance,
                 int clusters_apart) {
  for (const std::string link : {"", "05"}) {
    const RegistrationNoise noise = registration_noise(map_m, {link.empty() ? 1.0 : 0.5, 15});
    CAPTURE(link);
    CHECK(noise.mean_rmse_m == Approx(row["eC" + link].get<double>()).epsilon(0.2 * tolerance));
    CHECK(noise.pooled_rmse_m == Approx(row["eCp" + link].get<double>()).epsilon(tolerance));
    CHECK(std::abs(noise.clusters - row["ncl" + link].get<std::int64_t>()) <= clusters_apart);
  }
}

}  // namespace

TEST_CASE("quality: case 0 as an independent implementation measured it") {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("the shared SLAM cases are absent: skipped");
    return;
  }
  const auto reference = quality_reference(*folder);
  SECTION("chain") {
    const QualityMap map_m = case0_map(*folder, "case0_chain_pose.csv");
    check_sharpness(map_m, reference["reference"]["chain"], 1e-4);
    check_noise(map_m, reference["reference"]["chain"], 1e-6, 0);
  }
  SECTION("truth") {
    const QualityMap map_m = case0_map(*folder, "case0_true_pose.csv");
    check_sharpness(map_m, reference["reference"]["truth"], 1e-9);
    check_noise(map_m, reference["reference"]["truth"], 1e-6, 0);
  }
  SECTION("rechain") {
    const QualityMap map_m = case0_map(*folder, "case0_rechain_pose.csv");
    check_sharpness(map_m, reference["reference_ms"]["rechain"], 1e-9);
    // The two programs that made the reference take pairs of grid points exactly one link apart
    // (2 % of the cells) differently; here that joins two thickets.
    check_noise(map_m, reference["reference_ms"]["rechain"], 0.06, 2);
  }
}

}  // namespace honka
