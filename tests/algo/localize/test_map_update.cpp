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
  CHECK(updater.landmarks()[0].expected[1] == 1);
  CHECK(updater.add_view({{-3.0, 0.0}, 0.0}, {{NAN, 0.0}}));
  CHECK(updater.landmarks().size() == 1);
  CHECK_THROWS_AS(MapUpdater({{NAN, 0.0}}, {}), UserError);
}
