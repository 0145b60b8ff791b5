#include "eval/run/localize/sighting_summary.h"

#include <algorithm>
#include <cmath>

namespace honka::eval {
namespace {

using RowNumbers = std::vector<std::size_t>;

struct SightingGroup {
  std::string name, method;
  RowNumbers rows;
};

std::vector<SightingGroup> sighting_groups(const Table& table) {
  const auto& names = table.strings("case");
  const auto& methods = table.strings("method");
  std::vector<SightingGroup> groups;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const SightingGroup& g) {
      return g.name == names[row] && g.method == methods[row];
    });
    if (group == groups.end()) group = groups.insert(group, {names[row], methods[row], {}});
    group->rows.push_back(row);
  }
  return groups;
}

/// Values of these rows that are there.
std::vector<double> known(const std::vector<double>& column, const RowNumbers& rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) {
    if (!std::isnan(column[row])) values.push_back(column[row]);
  }
  return values;
}

std::int64_t count_flags(const std::vector<std::int64_t>& flags, const RowNumbers& rows) {
  return std::count_if(rows.begin(), rows.end(), [&](std::size_t row) { return flags[row] != 0; });
}

double mean_count(const std::vector<std::int64_t>& column, const RowNumbers& rows) {
  double sum = 0.0;
  for (const std::size_t row : rows) sum += static_cast<double>(column[row]);
  return rows.empty() ? 0.0 : sum / static_cast<double>(rows.size());
}

std::optional<double> over(const std::optional<double>& error, const std::optional<double>& bound) {
  if (!error || !bound || *bound <= 0.0) return std::nullopt;
  return *error / *bound;
}

/// RMS errors of the successes beside their bounds and what the matcher states, over the same rows.
void summarize_errors(const Table& table, const RowNumbers& rows, SightingSummary& summary) {
  RowNumbers judged;
  for (const std::size_t row : rows) {
    const bool bounded = !std::isnan(table.doubles("bound_m")[row]);
    if (table.ints("success")[row] != 0 && bounded) judged.push_back(row);
  }
  const auto rms = [&](const char* name) { return rmse(known(table.doubles(name), judged)); };
  summary.rms_error_m = rms("translation_error_m");
  summary.rms_bound_m = rms("bound_m");
  summary.error_over_bound = over(summary.rms_error_m, summary.rms_bound_m);
  summary.rotation_over_bound = over(rms("rotation_error_rad"), rms("bound_rad"));
  std::erase_if(judged,
                [&](std::size_t row) { return std::isnan(table.doubles("stated_m")[row]); });
  summary.error_over_stated = over(rms("translation_error_m"), rms("stated_m"));
}

/// What the maps of the group cost.
void summarize_maps(const Table& maps, SightingSummary& summary) {
  RowNumbers rows;
  for (std::size_t row = 0; row < maps.rows(); ++row) {
    if (maps.strings("case")[row] == summary.name && maps.strings("method")[row] == summary.method)
      rows.push_back(row);
  }
  summary.build_ms = median(known(maps.doubles("build_ms"), rows)).value_or(0.0);
  summary.index_bytes = maximum(known(maps.doubles("index_bytes"), rows));
  summary.memory_bytes = maximum(known(maps.doubles("memory_bytes"), rows));
}

SightingSummary summarize_sighting_group(const Table& maps, const Table& lists,
                                         const SightingGroup& group) {
  SightingSummary summary;
  summary.name = group.name;
  summary.method = group.method;
  summary.stems_in_map = lists.ints("stems_in_map")[group.rows.front()];
  summary.queries = static_cast<std::int64_t>(group.rows.size());
  summary.successes = count_flags(lists.ints("success"), group.rows);
  summary.accepted = count_flags(lists.ints("accepted"), group.rows);
  const auto& verdicts = lists.strings("verdict");
  summary.ambiguous = std::count_if(group.rows.begin(), group.rows.end(),
                                    [&](std::size_t row) { return verdicts[row] == "ambiguous"; });
  summary.stems = mean_count(lists.ints("stems"), group.rows);
  summary.true_stems = mean_count(lists.ints("true_stems"), group.rows);
  const auto wilson = [&](std::int64_t count) {
    return wilson_interval(count, summary.queries).value_or(Interval{0.0, 1.0});
  };
  summary.success_interval = wilson(summary.successes);
  summary.wrong_interval = wilson(summary.wrong());
  summarize_errors(lists, group.rows, summary);
  const auto times_ms = known(lists.doubles("match_ms"), group.rows);
  summary.time_p50_ms = percentile(times_ms, 50).value_or(0.0);
  summary.time_p95_ms = percentile(times_ms, 95).value_or(0.0);
  summarize_maps(maps, summary);
  return summary;
}

}  // namespace

std::vector<SightingSummary> summarize_sightings(const Table& maps, const Table& lists) {
  std::vector<SightingSummary> summaries;
  for (const SightingGroup& group : sighting_groups(lists)) {
    summaries.push_back(summarize_sighting_group(maps, lists, group));
  }
  return summaries;
}

}  // namespace honka::eval
