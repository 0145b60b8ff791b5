#include "eval/run/localize/map_update_rows.h"

#include <limits>

#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

constexpr double kMissingNumber = std::numeric_limits<double>::quiet_NaN();
using Ints = std::vector<std::int64_t>;
using Words = std::vector<std::string>;
using Doubles = std::vector<double>;

}  // namespace

Table map_quality_rows(const std::vector<MapUpdateDrive>& drives) {
  Table table({{"thinned_to_per_ha", "1/ha", "stems that the thinning left", Doubles{}},
               {"trial", "", "stand", Ints{}},
               {"fed_by", "", "matcher whose accepted poses updated the map", Words{}},
               {"part", "", "quarter of the drive that has ended; 0: before the drive", Ints{}},
               {"lists", "", "of the drive so far", Ints{}},
               {"accepted", "", "of these, accepted by fed_by in this map", Ints{}},
               {"counted", "", "of these, views that the updater counted", Ints{}},
               {"stems_in_map", "", "in all", Ints{}},
               {"felled", "", "felled stems of the old map in the area seen", Ints{}},
               {"felled_retired", "", "of these, taken out", Ints{}},
               {"standing", "", "standing stems of the old map in the area seen", Ints{}},
               {"standing_retired", "", "of these, taken out", Ints{}},
               {"unmapped", "", "standing trees there that the old map lacked", Ints{}},
               {"unmapped_added", "", "of these, in the map", Ints{}},
               {"added", "", "stems there that joined", Ints{}},
               {"falsely_added", "", "of these, without a tree of their own", Ints{}},
               {"seen_stems", "", "stems of the map in the area seen", Ints{}},
               {"seen_true", "", "of these, with a standing tree", Ints{}},
               {"seen_trees", "", "standing trees in the area seen", Ints{}},
               {"seen_trees_mapped", "", "of these, in the map", Ints{}},
               {"position_rmse_m", "m", "of true stems in the area seen", Doubles{}},
               {"added_rmse_m", "m", "of those of them that joined", Doubles{}},
               {"update_ms", "ms", "mean of an update with new matchers", Doubles{}, false}});
  for (const MapUpdateDrive& drive : drives) {
    for (const MapQuality& q : drive.maps) {
      table.add_row(drive.thinned_to_per_ha, drive.trial, q.fed_by, q.part, q.lists, q.accepted,
                    q.counted, q.stems_in_map, q.felled, q.felled_retired, q.standing,
                    q.standing_retired, q.unmapped, q.unmapped_added, q.added, q.falsely_added,
                    q.seen_stems, q.seen_true, q.seen_trees, q.seen_trees_mapped,
                    rmse(q.errors_m).value_or(kMissingNumber),
                    rmse(q.added_errors_m).value_or(kMissingNumber), q.update_ms);
    }
  }
  return table;
}

Table map_update_answer_rows(const std::vector<MapUpdateDrive>& drives) {
  Table table({{"thinned_to_per_ha", "1/ha", "stems that the thinning left", Doubles{}},
               {"trial", "", "stand", Ints{}},
               {"list", "", "number along the drive", Ints{}},
               {"part", "", "quarter of the drive, from 1", Ints{}},
               {"road", "", "strip road", Ints{}},
               {"method", "", "matcher", Words{}},
               {"map", "", "old | updated | new", Words{}},
               {"fed_by", "", "matcher whose accepted poses updated the map", Words{}},
               {"stems_in_map", "", "in all", Ints{}},
               {"stems", "", "in the list", Ints{}},
               {"verdict", "", "accepted | ambiguous | not_in_map | too_few_stems", Words{}},
               {"accepted", "", "1 when the answer was accepted", Ints{}},
               {"success", "", "1 when accepted and right", Ints{}},
               {"x_m", "m", "answer in the map; NaN when refused", Doubles{}},
               {"y_m", "m", "answer in the map; NaN when refused", Doubles{}},
               {"yaw_rad", "rad", "answer in the map; NaN when refused", Doubles{}},
               {"translation_error_m", "m", "to truth; NaN when refused", Doubles{}},
               {"rotation_error_rad", "rad", "to truth; NaN when refused", Doubles{}},
               {"match_ms", "ms", "matching alone, one thread", Doubles{}, false}});
  for (const MapUpdateDrive& drive : drives) {
    for (const MapUpdateAnswer& a : drive.answers) {
      const auto if_accepted = [&](double value) { return a.accepted() ? value : kMissingNumber; };
      table.add_row(drive.thinned_to_per_ha, drive.trial, a.list, a.part,
                    drive.road[static_cast<std::size_t>(a.list)], a.method, a.map, a.fed_by,
                    a.stems_in_map, a.stems, verdict_name(a.verdict), a.accepted(), a.success,
                    if_accepted(a.T_map_local.translation_m.x()),
                    if_accepted(a.T_map_local.translation_m.y()),
                    if_accepted(a.T_map_local.yaw_rad), if_accepted(a.translation_error_m),
                    if_accepted(a.rotation_error_rad), a.match_ms);
    }
  }
  return table;
}

}  // namespace honka::eval
