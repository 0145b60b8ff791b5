// A map that is kept up to date while the stand is thinned.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/map_update.h"
#include "algo/localize/matcher.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

using UpdatePoints = std::vector<Eigen::Vector2d>;

/// 160 × 60 m with a stem each 4 m or so. The old map knows all but the last row; a thinning then
/// takes two of five.
struct ThinnedStand {
  ThinnedStand() {
    for (std::uint64_t iy = 0; iy < 15; ++iy) {
      for (std::uint64_t ix = 0; ix < 40; ++ix) {
        RandomStream random(9, "thinned_stand", {ix, iy});
        const double x = 4.0 * static_cast<double>(ix) + random.uniform(-1.4, 1.4);
        const double y = 4.0 * static_cast<double>(iy) + random.uniform(-1.4, 1.4);
        const bool stands = random.uniform() >= 0.4;
        if (iy < 14) old_map.emplace_back(x, y);
        if (iy < 14) felled.push_back(stands ? 0 : 1);
        if (stands) standing.emplace_back(x, y);
      }
    }
  }

  /// Within 28 m, by several frames: all that stands, noise of 0.03 m.
  [[nodiscard]] UpdatePoints full_view(const Pose2& T_map_local, std::uint64_t number) const {
    RandomStream random(9, "thinned_full_view", {number});
    UpdatePoints seen;
    for (const Eigen::Vector2d& stem : standing) {
      Eigen::Vector2d local = T_map_local.inverse() * stem;
      if (local.norm() > 28.0) continue;
      local.x() += random.normal(0.0, 0.03);
      local.y() += random.normal(0.0, 0.03);
      seen.push_back(local);
    }
    return seen;
  }

  /// Seen with a chance that falls with range, noise of 0.1 m, and a few that are none.
  [[nodiscard]] UpdatePoints view(const Pose2& T_map_local, std::uint64_t number) const {
    RandomStream random(9, "thinned_view", {number});
    UpdatePoints seen;
    for (const Eigen::Vector2d& stem : standing) {
      Eigen::Vector2d local = T_map_local.inverse() * stem;
      const double chance = random.uniform();
      local.x() += random.normal(0.0, 0.1);
      local.y() += random.normal(0.0, 0.1);
      const bool inside = std::abs(std::atan2(local.y(), local.x())) < deg_to_rad(105.0);
      if (inside && chance < 0.95 - local.norm() / 50.0) seen.push_back(local);
    }
    for (int k = 0; k < 3; ++k) {
      seen.emplace_back(random.uniform(0.0, 20.0), random.uniform(-20.0, 20.0));
    }
    return seen;
  }

  UpdatePoints old_map, standing;
  std::vector<int> felled;
};

/// Along the middle and back.
Pose2 update_pose(int k) {
  const bool out = k < 60;
  const double x = out ? 10.0 + 2.4 * k : 10.0 + 2.4 * (119 - k);
  return {{x, out ? 20.0 : 36.0}, out ? 0.05 : kPi - 0.05};
}

MapUpdate update_thinned(const ThinnedStand& stand) {
  MapUpdater updater(stand.old_map, {});
  for (int k = 0; k < 120; ++k) {
    const Pose2 T_map_local = update_pose(k);
    CHECK(updater.add_view(T_map_local, stand.view(T_map_local, static_cast<std::uint64_t>(k))));
  }
  return updater.update();
}

/// Share of `of` with one of `in` within 0.5 m.
double share_found(const UpdatePoints& of, const UpdatePoints& in) {
  int found = 0;
  for (const Eigen::Vector2d& a : of) {
    const bool any = std::any_of(in.begin(), in.end(),
                                 [&](const Eigen::Vector2d& b) { return (a - b).norm() < 0.5; });
    found += any ? 1 : 0;
  }
  return static_cast<double>(found) / static_cast<double>(of.size());
}

int accepted_views(const ThinnedStand& stand, const UpdatePoints& map) {
  LocalizeSettings settings;
  settings.li2020.tolerance_m2 = 9.0;
  const auto matcher = create_matcher("li2020", map, settings);
  int right = 0;
  for (int k = 0; k < 120; k += 3) {
    const Pose2 truth = update_pose(k);
    const auto answer = matcher->locate(stand.full_view(truth, static_cast<std::uint64_t>(k)));
    const double error_m = (answer.T_map_local.translation_m - truth.translation_m).norm();
    right += answer.accepted() && error_m < 0.5 ? 1 : 0;
  }
  return right;
}

}  // namespace

TEST_CASE("After a thinning the updated map has what stands, and little else") {
  const ThinnedStand stand;
  const MapUpdate update = update_thinned(stand);
  const double precision_before = share_found(stand.old_map, stand.standing);
  const double precision = share_found(update.stems_in_map_m, stand.standing);
  const double recall_before = share_found(stand.standing, stand.old_map);
  const double recall = share_found(stand.standing, update.stems_in_map_m);
  INFO("precision " << precision_before << " -> " << precision << ", recall " << recall_before
                    << " -> " << recall);
  CHECK(precision_before < 0.65);
  CHECK(precision > 0.93);
  CHECK(recall > recall_before);
  CHECK(recall > 0.96);
  CHECK(update.added > 10);
  CHECK(std::is_sorted(update.detection_rate.rbegin(), update.detection_rate.rend()));
  int wrongly = 0;
  for (const std::size_t i : update.retired) wrongly += stand.felled[i] == 0 ? 1 : 0;
  CHECK(wrongly <= 5);
}

TEST_CASE("Localization succeeds more often in the updated map") {
  const ThinnedStand stand;
  const int before = accepted_views(stand, stand.old_map);
  const int after = accepted_views(stand, update_thinned(stand).stems_in_map_m);
  INFO(before << " -> " << after << " of 40");
  CHECK(after > before);
}

TEST_CASE("A map that nothing contradicts stays as it is") {
  const ThinnedStand stand;
  MapUpdater updater(stand.old_map, {});
  CHECK(updater.update().stems_in_map_m == stand.old_map);
  // Views that see everything of the old map retire nothing.
  for (int k = 0; k < 20; ++k) {
    UpdatePoints all;
    for (const Eigen::Vector2d& stem : stand.old_map) {
      all.push_back(update_pose(k).inverse() * stem);
    }
    updater.add_view(update_pose(k), all);
  }
  CHECK(updater.update().stems_in_map_m == stand.old_map);
}

TEST_CASE("Views from one place count once, and no number that is none gets in") {
  MapUpdater updater({{5.0, 0.0}}, {});
  CHECK(updater.add_view({}, {}));
  CHECK_FALSE(updater.add_view({{1.0, 0.0}, 0.0}, {}));
  REQUIRE(updater.landmarks()[0].views.size() == 1);
  CHECK(updater.landmarks()[0].views[0].bin == 1);
  CHECK(updater.add_view({{-3.0, 0.0}, 0.0}, {{NAN, 0.0}}));
  CHECK(updater.landmarks().size() == 1);
  // To and fro: each of the two places speaks once, as it was seen last.
  for (int k = 0; k < 20; ++k) {
    CHECK(updater.add_view({{k % 2 == 0 ? 0.0 : -3.0, 0.0}, 0.0}, {{k % 2 == 0 ? 5.0 : 8.0, 0.0}}));
  }
  REQUIRE(updater.landmarks()[0].views.size() == 2);
  CHECK(updater.landmarks()[0].views[0].seen);
  CHECK(updater.landmarks()[0].views[1].seen);
  CHECK_THROWS_AS(MapUpdater({{NAN, 0.0}}, {}), UserError);
}

TEST_CASE("At the edges of a view nothing is missed, and nothing founded beside itself") {
  // Half a metre from the range, from the ray at 105 degrees, and well inside both.
  const double edge = deg_to_rad(105.0);
  const Eigen::Vector2d aside =
      10.0 * Eigen::Vector2d(std::cos(edge - 0.03), std::sin(edge - 0.03));
  MapUpdater updater({{24.7, 0.0}, {25.1, 3.0}, aside, {10.0, 0.0}}, {});
  REQUIRE(updater.add_view({}, {{24.65, 0.0}, {24.8, 3.0}, {10.1, 0.0}}));
  CHECK(updater.landmarks().size() == 4);
  CHECK(updater.landmarks()[0].views.empty());
  CHECK(updater.landmarks()[1].views.empty());
  CHECK(updater.landmarks()[2].views.empty());
  CHECK(updater.landmarks()[3].views.size() == 1);
}

TEST_CASE("Two stems within the gate of one are two") {
  MapUpdater updater({{10.0, 0.0}, {10.0, 8.0}, {5.0, -6.0}, {15.0, -3.0}}, {});
  const UpdatePoints list = {{10.0, 0.0}, {10.4, 0.0}, {10.0, 8.0}, {5.0, -6.0}, {15.0, -3.0}};
  for (int k = 0; k < 6; ++k) {
    const Pose2 T_map_local{{-2.5 * k, 0.0}, 0.0};
    UpdatePoints local;
    for (const Eigen::Vector2d& stem : list) local.push_back(T_map_local.inverse() * stem);
    REQUIRE(updater.add_view(T_map_local, local));
  }
  const MapUpdate update = updater.update();
  CHECK(update.added == 1);
  REQUIRE(update.stems_in_map_m.size() == 5);
  CHECK((update.stems_in_map_m[4] - Eigen::Vector2d(10.4, 0.0)).norm() < 1e-9);
}

TEST_CASE("A view whose pose is wrong is left out, one a little off is fitted to the map") {
  const ThinnedStand stand;
  MapUpdater updater(stand.standing, {});
  const Pose2 truth = update_pose(20);
  const UpdatePoints list = stand.full_view(truth, 20);
  CHECK_FALSE(updater.add_view({truth.translation_m + Eigen::Vector2d(31.0, 7.0), 2.0}, list));
  for (const MapLandmark& landmark : updater.landmarks()) CHECK(landmark.views.empty());
  // 0.25 m and 1 degree off: 0.7 m at the range, beyond the gate.
  const Pose2 off{truth.translation_m + Eigen::Vector2d(0.2, -0.15), truth.yaw_rad + 0.0175};
  REQUIRE(updater.add_view(off, list));
  CHECK(updater.landmarks().size() == stand.standing.size());
  int seen = 0, missed = 0;
  for (const MapLandmark& landmark : updater.landmarks()) {
    for (const LandmarkView& view : landmark.views) ++(view.seen ? seen : missed);
  }
  CHECK(seen > 30);
  CHECK(missed == 0);
}

TEST_CASE("What is felled after the machine came by often is retired at its next coming") {
  const ThinnedStand stand;
  MapUpdater updater(stand.old_map, {});
  std::uint64_t number = 0;
  const auto drive = [&](const UpdatePoints& standing) {
    ThinnedStand seen = stand;
    seen.standing = standing;
    for (int k = 0; k < 120; ++k, ++number) {
      static_cast<void>(updater.add_view(update_pose(k), seen.view(update_pose(k), number)));
    }
  };
  const auto felled_retired = [&] {
    std::size_t count = 0;
    for (const std::size_t i : updater.update().retired) count += stand.felled[i] == 1 ? 1U : 0U;
    return count;
  };
  for (int pass = 0; pass < 3; ++pass) drive(stand.old_map);
  CHECK(updater.update().retired.size() < 10);
  drive(stand.standing);
  const auto felled =
      static_cast<std::size_t>(std::count(stand.felled.begin(), stand.felled.end(), 1));
  CHECK(felled_retired() > 0.9 * static_cast<double>(felled));
  // A retired stem that is seen again comes back.
  drive(stand.old_map);
  CHECK(felled_retired() < 0.05 * static_cast<double>(felled));
}

TEST_CASE("A stem that joins lies in the middle of where it was seen") {
  const ThinnedStand stand;
  const UpdatePoints& truth = stand.standing;
  const MapUpdate update = update_thinned(stand);
  double squares_m2 = 0.0;
  int joined = 0;
  for (std::size_t i = update.stems_in_map_m.size() - update.added;
       i < update.stems_in_map_m.size(); ++i) {
    double nearest_m = 1.0;
    for (const Eigen::Vector2d& stem : truth) {
      nearest_m = std::min(nearest_m, (update.stems_in_map_m[i] - stem).norm());
    }
    if (nearest_m >= 0.5) continue;
    squares_m2 += nearest_m * nearest_m;
    ++joined;
  }
  REQUIRE(joined > 10);
  CHECK(std::sqrt(squares_m2 / joined) < 0.07);  // one sighting: 0.14 m
}
