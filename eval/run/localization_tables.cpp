#include "eval/run/localization_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "eval/run/paper_li2020.h"

namespace honka::eval {
namespace {

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string percent_interval(const Interval& interval) {
  return fmt::format("{:.1f} – {:.1f}", 100 * interval.low, 100 * interval.high);
}

std::string mean_sd_max(const ErrorStatistics& s, int decimals) {
  return fmt::format("{} ± {}, max {}", fixed(or_nan(s.mean), decimals),
                     fixed(or_nan(s.sd), decimals), fixed(or_nan(s.max), decimals));
}

std::string ratio(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return "–";
  return fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::optional<double> percent(const std::optional<PaperRow>& paper) {
  if (!paper) return std::nullopt;
  return 100.0 * paper->success_rate;
}

std::vector<ReportCell> paper_cells(const LocalizationSummary& s) {
  const auto paper = paper_row(s.frames);
  const auto of_paper = [&](double PaperRow::*member) {
    return paper ? std::optional<double>((*paper).*member) : std::nullopt;
  };
  ReportCell translation{mean_sd_max(s.translation_m, 2)};
  ReportCell rotation{mean_sd_max(s.rotation_deg, 2)};
  ReportCell time{fmt::format("{:.0f} / {:.0f}", s.online_p50_ms, s.online_p95_ms)};
  if (paper) {
    translation.paper = fmt::format("{:.1f} ± {:.2f}, max {:.1f}", kPaperTranslationMean_m,
                                    kPaperTranslationSd_m, kPaperTranslationMax_m);
    if (paper->max_rotation_deg) {
      rotation.paper = fmt::format("max {:.2f}", *paper->max_rotation_deg);
    }
    if (paper->time_s) time.paper = fmt::format("about {:.0f}", 1e3 * *paper->time_s);
  }
  return {{fmt::format("{}", s.frames)},
          compared(s.trunks, of_paper(&PaperRow::trunks), 1),
          compared(s.matches, of_paper(&PaperRow::matching_triangles), 2),
          compared(100 * s.success_rate(), percent(paper), 1),
          {percent_interval(s.success_interval)},
          {fmt::format("{} of {}", s.successes, s.windows)},
          {fmt::format("{:.1f}", 100 * s.wrong_rate())},
          translation,
          rotation,
          {mean_sd_max(s.to_odometry_m, 2)},
          time};
}

}  // namespace

std::vector<std::string> localization_protocol(const Scenario& scenario) {
  const ProtocolSettings& p = scenario.protocol;
  return {
      fmt::format(
          "Windows are disjoint runs of consecutive key frames ({} m or {}° apart by the "
          "odometry, {} sweep(s) each); {}.",
          scenario.frame.distance_m, scenario.frame.angle_deg, scenario.frame.sweeps,
          p.windows_of == "each"
              ? "each number of frames has disjoint windows of its own, evenly over the "
                "drive, so that rows of different numbers answer for different places"
              : "a row of n frames takes the last n of each window, so that all rows answer "
                "for the same places"),
      fmt::format("Success: the method accepts (at least {} matching triangles agree on the pose) "
                  "and the pose lies within {} m and {}° of the truth. Accepted but outside these "
                  "limits is wrong; refused and wrong windows stay in every rate.",
                  scenario.localize.li2020.min_agreeing, p.success_translation_m,
                  p.success_rotation_deg),
      "Intervals of success are Wilson's, 95 %, over disjoint windows. Errors are mean ± s.d. and "
      "greatest over the successes, to truth and to the odometry track.",
      "Times are wall times of one thread while all asked threads work: gathering the points, "
      "Algorithm 1, and matching with its triangulation, p50 / p95 over windows. The paper's "
      "times are of an i7-9700K with matching in Python.",
  };
}

ReportTable paper_table(const std::vector<LocalizationSummary>& summaries,
                        const std::string& variant, const std::string& title,
                        const Scenario& scenario) {
  ReportTable table;
  table.title = title;
  table.headers = {{"frames"},
                   {"trunks"},
                   {"matching triangles"},
                   {"success", "%"},
                   {"95 % interval", "%"},
                   {"n of N"},
                   {"wrong", "%"},
                   {"error to truth", "m"},
                   {"rotation error", "deg"},
                   {"error to odometry", "m"},
                   {"time p50 / p95", "ms"}};
  for (const LocalizationSummary& summary : summaries) {
    if (summary.variant != variant) continue;
    table.rows.push_back(paper_cells(summary));
    table.protocol = fmt::format(
        "map: {}; tolerance {} m²; success: {} agreeing triangles and within {} m, {}°",
        summary.map, summary.tolerance_m2, scenario.localize.li2020.min_agreeing,
        scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg);
  }
  return table;
}

ReportTable variants_table(const std::vector<LocalizationSummary>& summaries) {
  ReportTable table;
  table.title = "Every variant on the same windows";
  table.protocol =
      "repaired: height band 0.4–7 m above the estimated ground, unbiased centres; "
      "survival: local stars that stand unchanged in the map's graph; keeps up: speed at which a "
      "key frame comes every p95 of the time";
  table.headers = {{"variant"},        {"map"},          {"frames"},
                   {"trunks"},         {"matches"},      {"star survival", "%"},
                   {"accepted", "%"},  {"success", "%"}, {"95 % interval", "%"},
                   {"wrong", "%"},     {"error", "m"},   {"error / bound"},
                   {"keeps up", "m/s"}};
  for (const LocalizationSummary& s : summaries) {
    const double survival = s.local_stars > 0 ? 100.0 * s.surviving / s.local_stars : 0.0;
    table.rows.push_back({{s.variant},
                          {s.map},
                          {fmt::format("{}", s.frames)},
                          {fixed(s.trunks, 1)},
                          {fixed(s.matches, 2)},
                          {fixed(survival, 1)},
                          {fixed(100 * s.accepted_rate(), 1)},
                          {fixed(100 * s.success_rate(), 1)},
                          {percent_interval(s.success_interval)},
                          {fixed(100 * s.wrong_rate(), 1)},
                          {fixed(or_nan(s.translation_m.mean), 3)},
                          {fixed(or_nan(s.error_over_bound), 1)},
                          {fixed(s.keeps_up_m_s, 1)}});
  }
  return table;
}

ReportTable detection_table(const std::vector<DetectionSummary>& summaries,
                            const Scenario& scenario) {
  ReportTable table;
  table.title = "Stems found, by range";
  table.protocol = fmt::format(
      "recall / precision; a found stem is true when a tree stands within {} m; trees in the field "
      "of view of the last key frame count, hidden ones too",
      scenario.protocol.stem_gate_m);
  table.headers = {{"chain"}, {"frames"}, {"stem RMSE", "m"}};
  if (summaries.empty()) return table;
  for (const auto& bin : summaries.front().bins) {
    table.headers.push_back({fmt::format("{:.0f}–{:.0f} m", bin.low_m, bin.high_m)});
  }
  for (const DetectionSummary& summary : summaries) {
    std::vector<ReportCell> row = {{summary.variant},
                                   {fmt::format("{}", summary.frames)},
                                   {fixed(or_nan(summary.stem_rmse_m), 3)}};
    for (const auto& bin : summary.bins) {
      row.push_back({ratio(bin.trees_found, bin.trees) + " / " + ratio(bin.found_true, bin.found)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable world_table(const Table& trials) {
  ReportTable table;
  table.title = "The world, its scans and its maps";
  table.protocol =
      "one row a stand; maps: recall / precision / position RMSE against the trees "
      "within the map's range of its run";
  table.headers = {{"stand"},
                   {"trees"},
                   {"key frames"},
                   {"windows"},
                   {"returns on stems", "%"},
                   {"hits a stem"},
                   {"at 0–10 | –20 | –30 | –47 m"},
                   {"map of the prior run"},
                   {"map of the same run"},
                   {"repaired map"}};
  const auto number = [&](const char* name, std::size_t row) { return trials.doubles(name)[row]; };
  const auto map_cell = [&](const std::string& map, std::size_t row) {
    const double stems = number((map + "_stems").c_str(), row);
    if (std::isnan(stems)) return ReportCell{"–"};
    return ReportCell{fmt::format("{:.0f} stems: {:.1f} % / {:.1f} % / {:.2f} m", stems,
                                  100 * number((map + "_recall").c_str(), row),
                                  100 * number((map + "_precision").c_str(), row),
                                  number((map + "_rmse_m").c_str(), row))};
  };
  for (std::size_t row = 0; row < trials.rows(); ++row) {
    table.rows.push_back({{fmt::format("{}", trials.ints("trial")[row])},
                          {fmt::format("{}", trials.ints("trees")[row])},
                          {fmt::format("{}", trials.ints("key_frames")[row])},
                          {fmt::format("{}", trials.ints("windows")[row])},
                          {fixed(100 * number("stem_share", row), 1)},
                          {fixed(number("hits_per_stem", row), 1)},
                          {fmt::format("{:.0f} | {:.0f} | {:.0f} | {:.0f}",
                                       number("hits_0_10_m", row), number("hits_10_20_m", row),
                                       number("hits_20_30_m", row), number("hits_30_47_m", row))},
                          map_cell("prior_map", row),
                          map_cell("same_run_map", row),
                          map_cell("repaired_map", row)});
  }
  table.notes.push_back(
      "The paper: \"an average of 100 laser hits\" a tree, and stem points about 1 % of a scan.");
  return table;
}

ReportTable odometry_table(const Table& trials) {
  ReportTable table;
  table.title = "The odometry of both runs";
  table.protocol =
      "position error: RMSE of the key frames after the odometry's frame is laid onto the world by "
      "yaw and translation (truth and noise: as it is); not registered: sweeps that follow the "
      "prediction alone and are in no key frame";
  table.headers = {{"stand"},
                   {"prior run: position error", "m"},
                   {"not registered", "sweeps"},
                   {"localized run: position error", "m"},
                   {"not registered", "sweeps"}};
  for (std::size_t row = 0; row < trials.rows(); ++row) {
    const auto cell = [&](const char* name, int decimals) {
      return ReportCell{fixed(trials.doubles(name)[row], decimals)};
    };
    table.rows.push_back({{fmt::format("{}", trials.ints("trial")[row])},
                          cell("prior_odometry_ate_m", 3),
                          cell("prior_unregistered_sweeps", 0),
                          cell("odometry_ate_m", 3),
                          cell("unregistered_sweeps", 0)});
  }
  return table;
}

ReportTable time_table(const std::vector<LocalizationSummary>& summaries) {
  ReportTable table;
  table.title = "Time of each stage";
  table.protocol = "median over windows, one thread a window";
  table.headers = {
      {"variant"},     {"frames"},         {"gather points", "ms"}, {"Algorithm 1", "ms"},
      {"match", "ms"}, {"all, p50", "ms"}, {"all, p95", "ms"},      {"keeps up with", "m/s"}};
  for (const LocalizationSummary& s : summaries) {
    if (s.variant != "default" && s.variant != "repaired") continue;
    table.rows.push_back({{s.variant},
                          {fmt::format("{}", s.frames)},
                          {fixed(s.aggregate_p50_ms, 1)},
                          {fixed(s.extract_p50_ms, 1)},
                          {fixed(s.match_p50_ms, 2)},
                          {fixed(s.online_p50_ms, 1)},
                          {fixed(s.online_p95_ms, 1)},
                          {fixed(s.keeps_up_m_s, 1)}});
  }
  table.notes.push_back("The paper keeps up with 0.5 m/s at 10 frames and 1 m/s at 1 to 5.");
  return table;
}

}  // namespace honka::eval
