#include "eval/run/localize/map_update_summary.h"

#include <algorithm>

#include "eval/metrics/clusters.h"

namespace honka::eval {
namespace {

/// Answers of one row of the table, with the road of each as its cluster.
struct AnswerGroup {
  MapUpdateSummary what;
  std::vector<const MapUpdateAnswer*> answers;
  std::vector<std::int64_t> roads;
};

bool is_same(const MapUpdateSummary& s, const MapUpdateDrive& drive, const MapUpdateAnswer& a) {
  return s.thinned_to_per_ha == drive.thinned_to_per_ha && s.method == a.method && s.map == a.map &&
         s.fed_by == a.fed_by;
}

std::vector<AnswerGroup> whole_drives(const std::vector<MapUpdateDrive>& drives) {
  std::vector<AnswerGroup> groups;
  std::int64_t roads_before = 0;  // roads of two stands are two clusters
  for (const MapUpdateDrive& drive : drives) {
    std::int64_t roads = 0;
    for (const MapUpdateAnswer& a : drive.answers) {
      auto group = std::find_if(groups.begin(), groups.end(),
                                [&](const AnswerGroup& g) { return is_same(g.what, drive, a); });
      if (group == groups.end()) {
        group = groups.insert(group, AnswerGroup{});
        group->what.thinned_to_per_ha = drive.thinned_to_per_ha;
        group->what.felled_share = drive.felled_share;
        group->what.method = a.method;
        group->what.map = a.map;
        group->what.fed_by = a.fed_by;
      }
      const std::int64_t road = drive.road[static_cast<std::size_t>(a.list)];
      group->answers.push_back(&a);
      group->roads.push_back(roads_before + road);
      roads = std::max(roads, road + 1);
    }
    roads_before += roads;
  }
  return groups;
}

AnswerGroup part_of(const AnswerGroup& whole, std::int64_t part) {
  AnswerGroup group;
  group.what = whole.what;
  group.what.part = part;
  for (std::size_t i = 0; i < whole.answers.size(); ++i) {
    if (whole.answers[i]->part != part) continue;
    group.answers.push_back(whole.answers[i]);
    group.roads.push_back(whole.roads[i]);
  }
  return group;
}

Interval rate_interval(const std::vector<double>& flags, const std::vector<std::int64_t>& roads) {
  const auto n = static_cast<std::int64_t>(flags.size());
  const auto count = static_cast<std::int64_t>(std::count(flags.begin(), flags.end(), 1.0));
  const ClusterSpread spread = cluster_spread(flags, roads);
  return clustered_rate_interval(count, n, spread.widening).value_or(Interval{0.0, 1.0});
}

MapUpdateSummary summarized(const AnswerGroup& group) {
  MapUpdateSummary s = group.what;
  std::vector<double> right, wrong, errors_m, times_ms;
  for (const MapUpdateAnswer* a : group.answers) {
    ++s.queries;
    s.accepted += a->accepted() ? 1 : 0;
    s.successes += a->success ? 1 : 0;
    s.stems_in_map += static_cast<double>(a->stems_in_map);
    right.push_back(a->success ? 1.0 : 0.0);
    wrong.push_back(a->accepted() && !a->success ? 1.0 : 0.0);
    times_ms.push_back(a->match_ms);
    if (a->success) errors_m.push_back(a->translation_error_m);
  }
  s.stems_in_map /= static_cast<double>(std::max<std::int64_t>(1, s.queries));
  s.success_interval = rate_interval(right, group.roads);
  s.wrong_interval = rate_interval(wrong, group.roads);
  s.rmse_m = rmse(errors_m);
  s.time_p50_ms = percentile(times_ms, 50.0).value_or(0.0);
  s.time_p95_ms = percentile(times_ms, 95.0).value_or(0.0);
  return s;
}

void add_counts(MapQuality& sum, const MapQuality& q) {
  for (const auto count :
       {&MapQuality::stems_in_map, &MapQuality::lists, &MapQuality::accepted, &MapQuality::counted,
        &MapQuality::felled, &MapQuality::felled_retired, &MapQuality::standing,
        &MapQuality::standing_retired, &MapQuality::unmapped, &MapQuality::unmapped_added,
        &MapQuality::added, &MapQuality::falsely_added, &MapQuality::seen_stems,
        &MapQuality::seen_true, &MapQuality::seen_trees, &MapQuality::seen_trees_mapped}) {
    sum.*count += q.*count;
  }
  sum.errors_m.insert(sum.errors_m.end(), q.errors_m.begin(), q.errors_m.end());
  sum.added_errors_m.insert(sum.added_errors_m.end(), q.added_errors_m.begin(),
                            q.added_errors_m.end());
  sum.update_ms += q.update_ms;
}

}  // namespace

std::vector<MapUpdateSummary> summarize_answers(const std::vector<MapUpdateDrive>& drives) {
  std::vector<MapUpdateSummary> summaries;
  for (const AnswerGroup& whole : whole_drives(drives)) {
    summaries.push_back(summarized(whole));
    for (std::int64_t part = 1; part <= kDriveParts; ++part) {
      const AnswerGroup group = part_of(whole, part);
      if (!group.answers.empty()) summaries.push_back(summarized(group));
    }
  }
  return summaries;
}

std::vector<MapQualitySummary> summarize_maps(const std::vector<MapUpdateDrive>& drives) {
  std::vector<MapQualitySummary> summaries;
  for (const MapUpdateDrive& drive : drives) {
    for (const MapQuality& q : drive.maps) {
      auto at = std::find_if(summaries.begin(), summaries.end(), [&](const MapQualitySummary& s) {
        return s.thinned_to_per_ha == drive.thinned_to_per_ha && s.sum.fed_by == q.fed_by &&
               s.sum.part == q.part;
      });
      if (at == summaries.end()) {
        at = summaries.insert(at, MapQualitySummary{drive.thinned_to_per_ha, {}, 0});
        at->sum.fed_by = q.fed_by;
        at->sum.part = q.part;
      }
      add_counts(at->sum, q);
      ++at->drives;
    }
  }
  for (MapQualitySummary& s : summaries) s.sum.update_ms /= static_cast<double>(s.drives);
  return summaries;
}

}  // namespace honka::eval
