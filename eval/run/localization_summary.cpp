#include "eval/run/localization_summary.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "algo/types/angles.h"
#include "eval/run/localization_row.h"

namespace honka::eval {
namespace {

/// Rows of the table that belong together.
struct Group {
  std::string variant;
  std::int64_t frames = 0;
  std::vector<std::size_t> rows;
};

/// Variants in the order in which they first appear, each with its numbers of frames in theirs.
std::vector<Group> groups_of(const Table& table) {
  const auto& variants = table.strings("variant");
  const auto& frames = table.ints("frames");
  std::vector<std::vector<Group>> by_variant;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto of_variant = std::find_if(by_variant.begin(), by_variant.end(), [&](const auto& groups) {
      return !groups.empty() && groups.front().variant == variants[row];
    });
    if (of_variant == by_variant.end()) of_variant = by_variant.emplace(of_variant);
    auto group = std::find_if(of_variant->begin(), of_variant->end(),
                              [&](const Group& g) { return g.frames == frames[row]; });
    if (group == of_variant->end()) {
      group = of_variant->insert(group, {variants[row], frames[row], {}});
    }
    group->rows.push_back(row);
  }
  std::vector<Group> all;
  for (auto& groups : by_variant) all.insert(all.end(), groups.begin(), groups.end());
  return all;
}

std::vector<double> pick(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(column[row]);
  return values;
}

double mean_of(const std::vector<std::int64_t>& column, const std::vector<std::size_t>& rows) {
  double sum = 0.0;
  for (const std::size_t row : rows) sum += static_cast<double>(column[row]);
  return rows.empty() ? 0.0 : sum / static_cast<double>(rows.size());
}

std::vector<std::size_t> where(const std::vector<std::int64_t>& flags,
                               const std::vector<std::size_t>& rows) {
  std::vector<std::size_t> chosen;
  for (const std::size_t row : rows) {
    if (flags[row] != 0) chosen.push_back(row);
  }
  return chosen;
}

ErrorStatistics statistics_of(const std::vector<double>& values) {
  return {mean(values), standard_deviation(values), maximum(values)};
}

std::optional<Interval> over_stands(const Table& table, const std::vector<std::size_t>& rows) {
  std::map<std::int64_t, Block> stands;
  for (const std::size_t row : rows) {
    Block& block = stands[table.ints("trial")[row]];
    block.sum += static_cast<double>(table.ints("success")[row]);
    block.count += 1.0;
  }
  std::vector<Block> blocks;
  for (const auto& [trial, block] : stands) blocks.push_back(block);
  return bootstrap_ratio(blocks);
}

/// RMS of errors and of bounds over the same successes.
struct ErrorAndBound {
  std::optional<double> error, bound;
};

ErrorAndBound error_and_bound(const Table& table, const std::vector<std::size_t>& successes,
                              const char* error_column, const char* bound_column) {
  std::vector<double> errors, bounds;
  for (const std::size_t row : successes) {
    const double error = table.doubles(error_column)[row];
    const double bound = table.doubles(bound_column)[row];
    if (std::isnan(error) || std::isnan(bound)) continue;
    errors.push_back(error);
    bounds.push_back(bound);
  }
  return {rmse(errors), rmse(bounds)};
}

std::optional<double> over_bound(const Table& table, const std::vector<std::size_t>& successes) {
  const auto [error, bound] = error_and_bound(table, successes, "translation_error_m", "bound_m");
  if (!error || !bound || *bound <= 0.0) return std::nullopt;
  return *error / *bound;
}

void summarize_times(const Table& table, const Group& group, double key_frame_m,
                     LocalizationSummary& summary) {
  const auto aggregate = pick(table.doubles("aggregate_ms"), group.rows);
  const auto extract = pick(table.doubles("extract_ms"), group.rows);
  const auto match = pick(table.doubles("match_ms"), group.rows);
  std::vector<double> online;
  for (std::size_t i = 0; i < match.size(); ++i) {
    online.push_back(aggregate[i] + extract[i] + match[i]);
  }
  summary.online_p50_ms = percentile(online, 50).value_or(0.0);
  summary.online_p95_ms = percentile(online, 95).value_or(0.0);
  summary.match_p50_ms = percentile(match, 50).value_or(0.0);
  summary.match_p95_ms = percentile(match, 95).value_or(0.0);
  summary.aggregate_p50_ms = percentile(aggregate, 50).value_or(0.0);
  summary.extract_p50_ms = percentile(extract, 50).value_or(0.0);
  if (summary.online_p95_ms > 0.0) {
    summary.keeps_up_m_s = key_frame_m / (1e-3 * summary.online_p95_ms);
  }
}

LocalizationSummary summarize_group(const Table& table, const Group& group, double key_frame_m) {
  LocalizationSummary summary;
  const std::size_t first = group.rows.front();
  summary.variant = group.variant;
  summary.map = table.strings("map")[first];
  summary.method = table.strings("method")[first];
  summary.repaired = table.ints("repaired")[first] != 0;
  for (const std::size_t row : group.rows) {
    summary.stems_in_map = std::max(summary.stems_in_map, table.ints("stems_in_map")[row]);
  }
  summary.tolerance_m2 = table.doubles("tolerance_m2")[first];
  summary.frames = group.frames;
  summary.windows = static_cast<std::int64_t>(group.rows.size());
  const auto successes = where(table.ints("success"), group.rows);
  summary.successes = static_cast<std::int64_t>(successes.size());
  summary.accepted = static_cast<std::int64_t>(where(table.ints("accepted"), group.rows).size());
  summary.trunks = mean_of(table.ints("stems"), group.rows);
  summary.matches = mean_of(table.ints("matches"), group.rows);
  summary.local_stars = mean_of(table.ints("local_stars"), group.rows);
  summary.surviving = mean_of(table.ints("surviving_stars"), group.rows);
  summary.success_interval =
      wilson_interval(summary.successes, summary.windows).value_or(Interval{0.0, 1.0});
  summary.stands_interval = over_stands(table, group.rows);
  summary.translation_m = statistics_of(pick(table.doubles("translation_error_m"), successes));
  std::vector<double> rotation_deg = pick(table.doubles("rotation_error_rad"), successes);
  for (double& angle : rotation_deg) angle = rad_to_deg(angle);
  summary.rotation_deg = statistics_of(rotation_deg);
  summary.to_odometry_m = statistics_of(pick(table.doubles("error_to_odometry_m"), successes));
  summary.error_over_bound = over_bound(table, successes);
  const auto in_map = error_and_bound(table, successes, "error_in_map_m", "bound_in_map_m");
  summary.in_map_rms_m = in_map.error;
  summary.in_map_bound_m = in_map.bound;
  summarize_times(table, group, key_frame_m, summary);
  return summary;
}

}  // namespace

std::vector<LocalizationSummary> summarize(const Table& frames, const Scenario& scenario) {
  std::vector<LocalizationSummary> summaries;
  for (const Group& group : groups_of(frames)) {
    summaries.push_back(summarize_group(frames, group, scenario.frame.distance_m));
  }
  return summaries;
}

std::vector<DetectionSummary> summarize_detection(const Table& frames) {
  std::vector<DetectionSummary> summaries;
  for (const Group& group : groups_of(frames)) {
    if (group.variant != "default" && group.variant != "repaired") continue;
    DetectionSummary summary{group.variant, group.frames, {}, std::nullopt};
    for (std::size_t bin = 0; bin + 1 < kStemRanges_m.size(); ++bin) {
      const std::string suffix = range_suffix(bin);
      DetectionSummary::Bin counts{kStemRanges_m[bin], kStemRanges_m[bin + 1]};
      for (const std::size_t row : group.rows) {
        counts.found += frames.ints("found" + suffix)[row];
        counts.found_true += frames.ints("found_true" + suffix)[row];
        counts.trees += frames.ints("trees" + suffix)[row];
        counts.trees_found += frames.ints("trees_found" + suffix)[row];
      }
      summary.bins.push_back(counts);
    }
    std::vector<double> rmse_m;
    for (const std::size_t row : group.rows) {
      const double value = frames.doubles("stem_rmse_m")[row];
      if (!std::isnan(value)) rmse_m.push_back(value);
    }
    summary.stem_rmse_m = rmse(rmse_m);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

}  // namespace honka::eval
