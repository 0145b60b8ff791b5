#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "algo/slam/chain.h"
#include "algo/slam/correction/candidate_pairs.h"
#include "algo/slam/correction/poisson_choice.h"
#include "algo/slam/correction/power_coefficients.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/map_quality/blur.h"
#include "tests/support/slam_case.h"

namespace honka {
namespace {

struct CorrectionCase {
  std::vector<SparseFrame> frames;
  FramePoses chain, truth;
  std::vector<FramePair> candidates;  ///< I2 of the reference
  nlohmann::json reference;
};

std::optional<CorrectionCase> correction_case() {
  const auto folder = test::shared_slam_cases();
  if (!folder) {
    WARN("the shared SLAM cases are absent: skipped");
    return std::nullopt;
  }
  CorrectionCase c;
  for (auto& points : test::read_frame_points(*folder / "case0_points.csv.gz")) {
    c.frames.push_back({static_cast<std::int64_t>(c.frames.size()), std::move(points)});
  }
  c.chain = test::read_pose_rows(*folder / "case0_chain_pose.csv");
  c.truth = test::read_pose_rows(*folder / "case0_true_pose.csv");
  for (const auto& row : test::read_number_rows(*folder / "case0_I2.csv")) {
    c.candidates.push_back(
        {static_cast<std::uint32_t>(row[1]), static_cast<std::uint32_t>(row[0]), row[2], row[3]});
  }
  std::ifstream stream(*folder / "case0_reference.json");
  c.reference = nlohmann::json::parse(stream)["reference"];
  return c;
}

double largest_entry_apart(const Pose3& pose, const nlohmann::json& twelve) {
  double largest = 0.0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double other = twelve[static_cast<std::size_t>(4 * row + column)].get<double>();
      largest = std::max(largest, std::abs(pose.matrix()(row, column) - other));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("correction: frames 500 and 700 of case 0, each side and coefficient") {
  const auto c = correction_case();
  if (!c) return;
  MotionMetric metric;
  metric.nearest_refined = false;  // the reference takes the best of 41 shares
  const Correction correction{500, 700, between(c->truth, 500, 700)};
  for (const std::string side : {"right", "left"}) {
    for (const std::string coefficient : {"index", "path", "metric", "nearest"}) {
      CAPTURE(side, coefficient);
      const auto& row = c->reference["update_j500_i700"][side + "/" + coefficient];
      FramePoses poses = c->chain;
      const auto shares =
          power_coefficients(poses, 500, 700, power_coefficient(coefficient), {}, metric);
      apply_correction(poses, correction, shares, update_side(side));
      CHECK(largest_entry_apart(poses[600], row["p600"]) < 1e-9);
      CHECK(largest_entry_apart(poses[900], row["p900"]) < 1e-9);
      // Points are stored to a micrometre: single cells of some 30,000 may differ.
      CHECK(blur(map_points(c->frames, poses), {}) ==
            Approx(row["beta"].get<double>()).epsilon(2e-4));
    }
  }
}

TEST_CASE("correction: the near-Poisson-disk choice of case 0 is the reference's") {
  const auto c = correction_case();
  if (!c) return;
  const PoissonChoice choice = choose_near_poisson(c->candidates, 100);
  CHECK(choice.spacing == Approx(c->reference["eps"].get<double>()).epsilon(1e-12));
  const auto chosen = c->reference["I_index"].get<std::vector<std::size_t>>();
  REQUIRE(choice.chosen.size() == chosen.size());
  // By their frames: the reference's candidates hold some pairs twice.
  const auto frames_of = [&](const std::vector<std::size_t>& indices) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> frames;
    for (const std::size_t k : indices) frames.emplace(c->candidates[k].j, c->candidates[k].i);
    return frames;
  };
  CHECK(frames_of(choice.chosen) == frames_of(chosen));
}

TEST_CASE("correction: λ and e of case 0's candidates are the reference's") {
  const auto c = correction_case();
  if (!c) return;
  const ViewCone cone;
  const ViewOverlap overlap(cone);
  for (std::size_t k = 0; k < c->candidates.size(); k += 5) {
    const FramePair& pair = c->candidates[k];
    CAPTURE(pair.j, pair.i);
    const Pose3 T_j_i = between(c->chain, pair.j, pair.i);
    CHECK(overlap(T_j_i) == Approx(pair.overlap).margin(1.0 / 256.0 + 1e-9));
    const MatchQuality match =
        judge_match(c->frames[pair.j].points_m, c->frames[pair.i].points_m, T_j_i, cone, {});
    CHECK(match.error_m == Approx(pair.error_m).margin(1e-4));
  }
}

TEST_CASE("correction: candidate pairs of case 0 hold what they promise") {
  const auto c = correction_case();
  if (!c) return;
  CandidatePairSettings settings;
  settings.wanted = 400;
  for (const std::string test : {"nearest", "icp"}) {
    CAPTURE(test);
    settings.test = test;
    const CandidatePairs found = find_candidate_pairs(c->frames, c->chain, {}, {}, {}, settings, 7);
    CHECK(found.promising.size() == 400);
    CHECK(found.tried < settings.tries);
    for (const FramePair& pair : found.promising) {
      CHECK(pair.gap() >= 2);
      CHECK(pair.gap() <= 1000);
      CHECK(pair.overlap > settings.overlap_limit);
      CHECK(pair.error_m < settings.error_limit_m(pair.overlap));
    }
    for (const FramePair& pair : found.inferior) {
      CHECK(pair.error_m >= settings.error_limit_m(pair.overlap));
    }
  }
}

}  // namespace honka
