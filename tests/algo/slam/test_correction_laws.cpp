#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "algo/slam/chain.h"
#include "algo/slam/correction/candidate_pairs.h"
#include "algo/slam/correction/order.h"
#include "algo/slam/correction/poisson_choice.h"
#include "algo/slam/correction/power_coefficients.h"
#include "algo/slam/correction/update.h"
#include "algo/types/random.h"

namespace honka {
namespace {

Pose3 random_step(std::uint64_t k, double metres, double radians) {
  RandomStream random(11, "correction_step", {k});
  return pose_from_rpy({random.uniform(0.0, metres), random.normal(0.0, 0.1 * metres),
                        random.normal(0.0, 0.05 * metres)},
                       random.normal(0.0, 0.2 * radians), random.normal(0.0, 0.2 * radians),
                       random.normal(0.0, radians));
}

FramePoses random_chain(std::size_t frames) {
  FramePoses poses(1, Pose3::Identity());
  while (poses.size() < frames) {
    poses.push_back(poses.back() * random_step(poses.size(), 0.5, 0.1));
  }
  return poses;
}

double poses_apart(const Pose3& a, const Pose3& b) { return (a.matrix() - b.matrix()).norm(); }

std::vector<FramePair> random_pairs(std::size_t count) {
  std::vector<FramePair> pairs;
  for (std::uint64_t k = 0; k < count; ++k) {
    RandomStream random(2, "correction_pairs", {k});
    FramePair pair;
    pair.j = static_cast<std::uint32_t>(random.below(900));
    pair.i = pair.j + 2 + static_cast<std::uint32_t>(random.below(100));
    pairs.push_back(pair);
  }
  return pairs;
}

const std::vector<double>& law_errors() {
  static const std::vector<double> kErrors = [] {
    std::vector<double> errors;
    for (int k = 0; k < 59; ++k) errors.push_back(0.1 + 0.01 * (k % 7));
    return errors;
  }();
  return kErrors;
}

}  // namespace

TEST_CASE("correction: laws of every coefficient and side") {
  const FramePoses before = random_chain(60);
  const std::size_t j = 12, i = 41;
  for (const std::string& name : power_coefficient_names()) {
    CAPTURE(name);
    const auto shares = power_coefficients(before, j, i, power_coefficient(name), law_errors(), {});
    REQUIRE(shares.size() == i - j + 1);
    CHECK(shares.front() == 0.0);
    CHECK(shares.back() == 1.0);
    CHECK(std::all_of(shares.begin(), shares.end(), [](double u) { return u >= 0.0 && u <= 1.0; }));
    const bool cumulative = name == "index" || name == "path" || name == "errors";
    if (cumulative) CHECK(std::is_sorted(shares.begin(), shares.end()));
    for (const std::string& side : update_side_names()) {
      CAPTURE(side);
      for (const double metres : {0.0, 1e-9, 0.5, 20.0}) {
        const Pose3 T_j_i = between(before, j, i) * random_step(77, metres, 0.05 * metres);
        FramePoses after = before;
        apply_correction(after, {j, i, T_j_i}, shares, update_side(side));
        CHECK(poses_apart(between(after, j, i), T_j_i) < 1e-9 * (1.0 + metres));
        for (std::size_t l = 0; l <= j; ++l) CHECK(after[l].matrix() == before[l].matrix());
        for (std::size_t k = i + 1; k < after.size(); ++k) {
          CHECK(poses_apart(between(after, i, k), between(before, i, k)) < 1e-9);
        }
        for (const Pose3& pose : after) {
          CHECK(pose.matrix().allFinite());
          CHECK((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm() <
                1e-12);
        }
      }
      FramePoses same = before;
      apply_correction(same, {j, i, between(before, j, i)}, shares, update_side(side));
      for (std::size_t l = 0; l < same.size(); ++l) CHECK(poses_apart(same[l], before[l]) < 1e-9);
    }
  }
}

TEST_CASE("correction: a straight road pulled longer stretches evenly on both sides") {
  FramePoses poses(1, Pose3::Identity());
  for (int l = 1; l <= 10; ++l) poses.push_back(Pose3(Eigen::Translation3d(l, 0.0, 0.0)));
  for (const std::string& side : update_side_names()) {
    for (const std::string& name : power_coefficient_names()) {
      CAPTURE(side, name);
      const std::vector<double> errors(10, 0.2);
      FramePoses after = poses;
      const auto shares = power_coefficients(poses, 2, 6, power_coefficient(name), errors, {});
      apply_correction(after, {2, 6, Pose3(Eigen::Translation3d(6.0, 0.0, 0.0))}, shares,
                       update_side(side));
      CHECK(after[4].translation().x() == Approx(5.0).margin(1e-7));
      CHECK(after[6].translation().x() == Approx(8.0));
      CHECK(after[9].translation().x() == Approx(11.0));
    }
  }
}

TEST_CASE("correction: a stretch that measures nothing falls back on the index") {
  const FramePoses still(9, Pose3::Identity());
  const std::vector<double> no_errors(8, 0.0);
  for (const std::string& name : power_coefficient_names()) {
    CAPTURE(name);
    const auto shares = power_coefficients(still, 0, 8, power_coefficient(name), no_errors, {});
    CHECK(shares.front() == 0.0);
    CHECK(shares.back() == 1.0);
    for (const double u : shares) CHECK(std::isfinite(u));
    if (name != "nearest") CHECK(shares[2] == Approx(0.25));
  }
}

TEST_CASE("correction: every order is a permutation, and sorted by what it says") {
  const std::vector<FramePair> pairs = random_pairs(101);
  std::vector<double> gaps;
  for (const FramePair& pair : pairs) gaps.push_back(pair.gap());
  std::nth_element(gaps.begin(), gaps.begin() + 50, gaps.end());
  const double median = gaps[50];
  for (const std::string& name : correction_order_names()) {
    CAPTURE(name);
    const auto order = order_corrections(pairs, correction_order(name), 4);
    CHECK(order == order_corrections(pairs, correction_order(name), 4));
    std::vector<std::size_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < sorted.size(); ++k) CHECK(sorted[k] == k);
    for (std::size_t k = 1; k < order.size(); ++k) {
      const double last = pairs[order[k - 1]].gap(), next = pairs[order[k]].gap();
      if (name == "small_gaps_first") CHECK(last <= next);
      if (name == "medium_gaps_first") CHECK(std::abs(last - median) <= std::abs(next - median));
    }
  }
  CHECK(order_corrections(pairs, CorrectionOrder::kRandom, 4) !=
        order_corrections(pairs, CorrectionOrder::kRandom, 5));
  CHECK(order_corrections({}, CorrectionOrder::kMediumGapsFirst, 1).empty());
}

TEST_CASE("correction: the choice covers the plane evenly") {
  SECTION("four far clumps, four wanted: one of each") {
    std::vector<FramePair> pairs;
    for (const std::uint32_t j : {0U, 1000U}) {
      for (const std::uint32_t i : {2000U, 3000U}) {
        for (std::uint32_t k = 0; k < 5; ++k) pairs.push_back({j + k, i + 2 * k, 0.0, 0.0});
      }
    }
    const PoissonChoice choice = choose_near_poisson(pairs, 4);
    REQUIRE(choice.chosen.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) CHECK(choice.chosen[k] / 5 == k);
  }
  SECTION("numbers asked for are nearly met, no pair comes twice") {
    const auto pairs = random_pairs(3000);
    for (const std::int64_t wanted : {1, 10, 50, 100}) {
      const PoissonChoice choice = choose_near_poisson(pairs, wanted);
      CAPTURE(wanted, choice.chosen.size());
      CHECK(choice.chosen.size() <= static_cast<std::size_t>(choice.grid_points));
      CHECK(std::adjacent_find(choice.chosen.begin(), choice.chosen.end(),
                               std::greater_equal<>()) == choice.chosen.end());
      CHECK(static_cast<double>(choice.grid_points) < 1.6 * static_cast<double>(wanted) + 3.0);
      CHECK(static_cast<double>(choice.grid_points) > 0.6 * static_cast<double>(wanted) - 3.0);
    }
  }
  SECTION("none, one, all alike, more wanted than there are") {
    CHECK(choose_near_poisson({}, 10).chosen.empty());
    CHECK(choose_near_poisson(random_pairs(5), 0).chosen.empty());
    CHECK(choose_near_poisson(std::vector<FramePair>(1, {3, 9, 0.5, 0.1}), 10).chosen.size() == 1);
    CHECK(choose_near_poisson(std::vector<FramePair>(8, {3, 9, 0.5, 0.1}), 3).chosen ==
          std::vector<std::size_t>{0});
    CHECK(choose_near_poisson(random_pairs(5), 1000).chosen.size() <= 5);
  }
}

TEST_CASE("correction: candidates where there can be none") {
  const CandidatePairSettings settings;
  for (const std::size_t count : {0U, 1U, 2U, 5U}) {
    const std::vector<SparseFrame> empty_frames(count);
    const FramePoses poses(count, Pose3::Identity());
    const CandidatePairs found = find_candidate_pairs(empty_frames, poses, {}, {}, {}, settings, 1);
    CHECK(found.promising.empty());
    CHECK(found.inferior.empty());
  }
}

}  // namespace honka
