// The paper's future work as options of li2020: laws, and equality with the literal form.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/li2020/branch_and_bound.h"
#include "algo/localize/li2020/submaps.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

using OptionPoints = std::vector<Eigen::Vector2d>;

/// A jittered grid of stems 4 m apart, so that no two places look alike.
OptionPoints option_map(int columns, int rows) {
  OptionPoints map;
  for (int iy = 0; iy < rows; ++iy) {
    for (int ix = 0; ix < columns; ++ix) {
      RandomStream random(5, "option_map",
                          {static_cast<std::uint64_t>(ix), static_cast<std::uint64_t>(iy)});
      map.emplace_back(4.0 * ix + random.uniform(-1.5, 1.5), 4.0 * iy + random.uniform(-1.5, 1.5));
    }
  }
  return map;
}

/// The stems within a reach of a sensor, in its frame, with noise.
OptionPoints option_view(const OptionPoints& map, const Pose2& T_map_local, double reach_m,
                         double noise_m, std::uint64_t seed) {
  RandomStream random(seed, "option_view");
  OptionPoints view;
  for (const Eigen::Vector2d& stem : map) {
    Eigen::Vector2d local = T_map_local.inverse() * stem;
    if (local.norm() > reach_m) continue;
    local.x() += random.normal(0.0, noise_m);
    local.y() += random.normal(0.0, noise_m);
    view.push_back(local);
  }
  return view;
}

/// Matches with noise about one pose, and so many false ones anywhere.
std::vector<PoseCandidate> bound_candidates(std::uint64_t seed, int right, int wrong) {
  RandomStream random(seed, "bound_candidates");
  const Pose2 truth{{random.uniform(-80.0, 80.0), random.uniform(-80.0, 80.0)},
                    random.uniform(-kPi, kPi)};
  std::vector<PoseCandidate> candidates;
  for (int k = 0; k < right + wrong; ++k) {
    const Pose2 T = k < right ? truth
                              : Pose2{{random.uniform(-80.0, 80.0), random.uniform(-80.0, 80.0)},
                                      random.uniform(-kPi, kPi)};
    PoseCandidate c;
    for (std::size_t j = 0; j < 6; ++j) {
      c.local_m[j] = {random.uniform(-25.0, 25.0), random.uniform(-25.0, 25.0)};
      c.map_m[j] =
          T * c.local_m[j] + Eigen::Vector2d(random.normal(0.0, 0.1), random.normal(0.0, 0.1));
    }
    c.T_map_local = {
        T.translation_m + Eigen::Vector2d(random.normal(0.0, 0.3), random.normal(0.0, 0.3)),
        wrap_to_pi(T.yaw_rad + random.normal(0.0, 0.02))};
    candidates.push_back(c);
  }
  return candidates;
}

/// A pose of B × D drawn at random.
Pose2 pose_in_box(const CandidateBox& box, RandomStream& random) {
  const double turn = random.uniform(box.low_rad, box.high_rad);
  const double x = random.uniform(box.low_m.x(), box.high_m.x());
  const double y = random.uniform(box.low_m.y(), box.high_m.y());
  return {{x, y}, wrap_to_pi(box.reference_rad + turn)};
}

}  // namespace

TEST_CASE("Branch and bound costs no more than the candidates and the box") {
  const int wrong = GENERATE(0, 1, 4);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto candidates = bound_candidates(seed, 4, wrong);
    const BoundedSelection global = select_by_bound(candidates);
    CHECK(global.certified);
    CHECK(global.best.cost_m <= select_candidate(candidates).cost_m);
    CHECK(global.best.cost_m <= select_in_box(candidates).cost_m);
    CHECK(global.lower_bound_m <= global.best.cost_m);
    CHECK(global.best.cost_m - global.lower_bound_m <=
          0.001 * 6.0 * static_cast<double>(candidates.size()));
    CHECK(total_cost_m(candidates, global.best.T_map_local) == Approx(global.best.cost_m));
  }
}

TEST_CASE("No pose of the box is below the lower bound") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto candidates = bound_candidates(seed, 2, 2);
    const BoundedSelection global = select_by_bound(candidates);
    const double reference = select_candidate(candidates).T_map_local.yaw_rad;
    const CandidateBox box(candidates, reference);
    RandomStream random(seed, "bound_poses");
    for (int k = 0; k < 2000; ++k) {
      CHECK(total_cost_m(candidates, pose_in_box(box, random)) >= global.lower_bound_m);
    }
  }
}

TEST_CASE("Branch and bound finds the exact pose of exact matches between wrong candidates") {
  std::vector<PoseCandidate> candidates = bound_candidates(3, 1, 0);
  const Pose2 truth{{12.0, -7.0}, 0.8};
  for (std::size_t j = 0; j < 6; ++j) candidates[0].map_m[j] = truth * candidates[0].local_m[j];
  candidates.push_back(candidates[0]);
  candidates[0].T_map_local = {{11.0, -8.0}, 0.7};  // the answer lies between the two
  candidates[1].T_map_local = {{13.5, -6.5}, 0.95};
  const BoundedSelection global = select_by_bound(candidates, std::nullopt, {1e-5, 1000000});
  CHECK(global.certified);
  CHECK((global.best.T_map_local.translation_m - truth.translation_m).norm() < 1e-3);
}

TEST_CASE("A search that may not go on says how far it came") {
  const auto candidates = bound_candidates(7, 2, 6);
  const BoundedSelection stopped = select_by_bound(candidates, std::nullopt, {0.0, 10});
  CHECK_FALSE(stopped.certified);
  CHECK(stopped.nodes == 10);
  CHECK(stopped.lower_bound_m < stopped.best.cost_m);
}

TEST_CASE("Answers of every selection stay within the prior") {
  const OptionPoints map = option_map(30, 30);
  const Pose2 truth{{60.0, 57.0}, 2.1};
  Li2020Settings settings;
  settings.selection = GENERATE("candidates", "box", "branch_and_bound");
  settings.tolerance_m2 = 9.0;
  settings.min_agreeing = 1;
  const Li2020Matcher matcher(map, settings);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto view = option_view(map, truth, 22.0, 0.15, seed);
    const double angle = static_cast<double>(seed);
    const Eigen::Vector2d aside = 4.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const LocatePrior prior{truth.translation_m + aside, 4.02};
    const LocateResult answer = matcher.locate(view, prior);
    if (answer.matches == 0) continue;
    CHECK((answer.T_map_local.translation_m - prior.position_in_map_m).norm() <=
          prior.radius_m + 1e-9);
  }
}

TEST_CASE("The active subset answers as the whole map where the prior is right") {
  const OptionPoints map = option_map(40, 40);
  const Li2020Matcher matcher(map, {});
  int near_candidates = 0, whole_candidates = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RandomStream random(seed, "active_subset");
    const Pose2 truth{{random.uniform(40.0, 120.0), random.uniform(40.0, 120.0)},
                      random.uniform(-kPi, kPi)};
    const auto view = option_view(map, truth, 22.0, 0.02, seed);
    const LocateResult whole = matcher.locate(view);
    const LocateResult everywhere = matcher.locate(view, LocatePrior{{80.0, 80.0}, 1e4});
    const LocateResult near = matcher.locate(view, LocatePrior{truth.translation_m, 5.0});
    REQUIRE(whole.accepted());
    CHECK(everywhere.T_map_local.translation_m == whole.T_map_local.translation_m);
    CHECK(everywhere.candidates == whole.candidates);
    CHECK(near.accepted());
    CHECK(near.agreeing >= whole.agreeing);
    CHECK(near.candidates <= whole.candidates);
    near_candidates += near.candidates;
    whole_candidates += whole.candidates;
    CHECK((near.T_map_local.translation_m - truth.translation_m).norm() < 0.2);
  }
  CHECK(near_candidates < whole_candidates);  // the cost falls
}

TEST_CASE("A prior that lies elsewhere is not in the map") {
  const OptionPoints map = option_map(40, 40);
  const Li2020Matcher matcher(map, {});
  const auto view = option_view(map, {{60.0, 60.0}, 0.3}, 22.0, 0.02, 1);
  CHECK(matcher.locate(view, LocatePrior{{5000.0, 0.0}, 30.0}).verdict == Verdict::kNotInMap);
  CHECK_FALSE(matcher.locate(view, LocatePrior{{120.0, 120.0}, 5.0}).accepted());
}

TEST_CASE("With a local radius only the near stems are matched, under their own numbers") {
  const OptionPoints map = option_map(30, 30);
  const Pose2 truth{{60.0, 57.0}, -1.0};
  const auto view = option_view(map, truth, 30.0, 0.0, 1);
  Li2020Settings settings;
  const LocateResult all = Li2020Matcher(map, settings).locate(view);
  settings.local_radius_m = 1e3;
  const LocateResult wide = Li2020Matcher(map, settings).locate(view);
  CHECK(wide.T_map_local.translation_m == all.T_map_local.translation_m);
  CHECK(wide.local_stars == all.local_stars);
  settings.local_radius_m = 18.0;
  const LocateResult near = Li2020Matcher(map, settings).locate(view);
  CHECK(near.stems == static_cast<int>(view.size()));
  CHECK(near.local_stars < all.local_stars);
  REQUIRE(near.accepted());
  for (const StarMatch& match : near.star_matches) {
    if (!match.agrees) continue;
    for (const VertexPair& pair : match.pairs) {
      const Eigen::Vector2d& local = view[static_cast<std::size_t>(pair.local)];
      CHECK(local.norm() <= 18.0);
      CHECK((truth * local - map[static_cast<std::size_t>(pair.map)]).norm() < 1e-6);
    }
  }
}

TEST_CASE("Away from borders sub-maps answer as the whole map") {
  const OptionPoints map = option_map(50, 40);
  Li2020Settings settings;
  settings.tolerance_m2 = 0.5;  // few false matches, which differ by the stars a graph holds
  const Li2020Matcher whole(map, settings);
  settings.submap_size_m = 110.0;
  settings.submap_overlap_m = 70.0;
  const SubmapMatcher tiled(map, settings);
  CHECK(tiled.tiles() == 4 * 3);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RandomStream random(seed, "submaps");
    const Pose2 truth{{random.uniform(40.0, 160.0), random.uniform(40.0, 120.0)},
                      random.uniform(-kPi, kPi)};
    const auto view = option_view(map, truth, 22.0, 0.0, seed);
    const LocateResult one = whole.locate(view);
    const LocateResult tile = tiled.locate(view);
    REQUIRE(one.accepted());
    REQUIRE(tile.accepted());
    CHECK(tile.agreeing == one.agreeing);
    CHECK((tile.T_map_local.translation_m - one.T_map_local.translation_m).norm() < 1e-6);
    for (const StarMatch& match : tile.star_matches) {
      if (!match.agrees) continue;
      for (const VertexPair& pair : match.pairs) {
        const Eigen::Vector2d seen = truth * view[static_cast<std::size_t>(pair.local)];
        CHECK((seen - map[static_cast<std::size_t>(pair.map)]).norm() < 1e-6);
      }
    }
    const LocateResult by_prior = tiled.locate(view, LocatePrior{truth.translation_m, 10.0});
    CHECK(by_prior.accepted());
  }
}

TEST_CASE("Sub-maps of bad input are told of") {
  Li2020Settings settings;
  settings.submap_size_m = 50.0;
  settings.submap_overlap_m = 50.0;
  CHECK_THROWS_AS(SubmapMatcher(option_map(20, 20), settings), UserError);
  settings.submap_overlap_m = 20.0;
  CHECK_THROWS_AS(SubmapMatcher({}, settings), UserError);
  CHECK_THROWS_AS(SubmapMatcher({{0.0, 0.0}, {NAN, 1.0}}, settings), UserError);
  const SubmapMatcher tiled(option_map(30, 30), settings);
  CHECK(tiled.locate(OptionPoints{}).verdict == Verdict::kTooFewStems);
  CHECK(tiled.locate(option_map(5, 5), LocatePrior{{1e5, 0.0}, 1.0}).verdict == Verdict::kNotInMap);
}
