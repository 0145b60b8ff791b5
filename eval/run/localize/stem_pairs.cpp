#include "eval/run/localize/stem_pairs.h"

#include <fmt/format.h>

#include <limits>

#include "algo/types/user_error.h"
#include "eval/config/words.h"
#include "eval/io/csv.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

fs::path pairs_folder(const ResolvedScenario& resolved) {
  const fs::path folder = resolved.scenario.pairs.folder;
  for (const fs::path& place : {folder, resolved.file.parent_path() / folder}) {
    if (fs::is_directory(place)) return place;
  }
  throw UserError(fmt::format(
      "pairs.folder: there is no folder {}; the pairs (FORTLS, Rioja.data) are not part of the "
      "project: name their folder, -s pairs.folder=FOLDER",
      folder.string()));
}

std::vector<Eigen::Vector2d> places_in(const fs::path& file) {
  std::vector<Eigen::Vector2d> places_m;
  for (const Stem& stem : read_stem_csv(file)) places_m.push_back(stem.position_m);
  return places_m;
}

StemPairRow ask_pair(const TimedMatcher& timed, const StemPairPlot& scan, const StemPairPlot& map,
                     const StemPairSettings& settings) {
  StemPairRow row;
  row.scan = scan.name;
  row.map = map.name;
  row.same_plot = &scan == &map;
  row.stems_in_map = static_cast<std::int64_t>(map.field_m.size());
  const Stopwatch watch;
  if (timed.matcher) row.result = timed.matcher->locate(scan.scan_m);
  row.match_ms = watch.milliseconds();
  if (!row.same_plot) return row;
  row.deviation = pose_error(row.result.T_map_local, map.T_field_scan);
  row.success =
      judge(row.result.accepted(), row.deviation, {settings.within_m, settings.within_deg})
          .success();
  return row;
}

}  // namespace

std::vector<StemPairPlot> read_stem_pairs(const ResolvedScenario& resolved) {
  const StemPairSettings& s = resolved.scenario.pairs;
  const fs::path folder = pairs_folder(resolved);
  const std::vector<std::string> names = words_of(s.names);
  if (names.empty() || s.yaw_deg.size() != names.size() || s.x_m.size() != names.size() ||
      s.y_m.size() != names.size()) {
    throw UserError(fmt::format(
        "pairs.names has {} names, pairs.yaw_deg {}, x_m {} and y_m {} numbers; give each plot one",
        names.size(), s.yaw_deg.size(), s.x_m.size(), s.y_m.size()));
  }
  std::vector<StemPairPlot> plots;
  for (std::size_t k = 0; k < names.size(); ++k) {
    plots.push_back({names[k], places_in(folder / (names[k] + "_field.csv")),
                     places_in(folder / (names[k] + "_tls.csv")),
                     Pose2{{s.x_m[k], s.y_m[k]}, wrap_to_pi(deg_to_rad(s.yaw_deg[k]))}});
  }
  return plots;
}

std::vector<StemPairRow> locate_stem_pairs(const Scenario& scenario,
                                           const std::vector<StemPairPlot>& plots) {
  std::vector<StemPairRow> rows;
  for (const std::string& method : methods_of(scenario.variants.methods, scenario.localize)) {
    for (const StemPairPlot& map : plots) {
      const TimedMatcher timed = make_timed_matcher(method, map.field_m, scenario.localize);
      for (const StemPairPlot& scan : plots) {
        rows.push_back(ask_pair(timed, scan, map, scenario.pairs));
        rows.back().method = method;
      }
    }
  }
  return rows;
}

Table stem_pair_table(const std::vector<StemPairRow>& rows) {
  const std::vector<std::int64_t> whole;
  const std::vector<double> none;
  const std::vector<std::string> text;
  Table table({{"method", "", "matcher", text},
               {"scan", "", "plot of the scan", text},
               {"map", "", "plot of the field map", text},
               {"same_plot", "", "1 for a pair", whole},
               {"stems", "", "stems in the scan", whole},
               {"stems_in_map", "", "stems in the field map", whole},
               {"inliers", "", "stems with a partner under the answer", whole},
               {"margin", "", "the matcher's own, over the acceptance", none},
               {"verdict", "", "accepted | ambiguous | not_in_map | too_few_stems", text},
               {"accepted", "", "1 when the answer was accepted", whole},
               {"success", "", "1 for an accepted pair near the brute-force answer", whole},
               {"deviation_m", "m", "of an accepted pair from the brute-force answer", none},
               {"deviation_rad", "rad", "of an accepted pair from the brute-force answer", none},
               {"match_ms", "ms", "matching alone, one thread", none, false}});
  for (const StemPairRow& row : rows) {
    const bool counts = row.same_plot && row.result.accepted();
    const double missing = std::numeric_limits<double>::quiet_NaN();
    table.add_row(row.method, row.scan, row.map, row.same_plot, row.result.stems, row.stems_in_map,
                  row.result.inliers, row.result.margin, verdict_name(row.result.verdict),
                  row.result.accepted(), row.success,
                  counts ? row.deviation.translation_m : missing,
                  counts ? row.deviation.rotation_rad : missing, row.match_ms);
  }
  return table;
}

}  // namespace honka::eval
