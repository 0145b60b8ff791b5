#include <fmt/format.h>

#include <algorithm>

#include "algo/types/angles.h"
#include "eval/report/figure_accuracy.h"
#include "eval/report/figure_errors.h"
#include "eval/report/figure_stem_recall.h"
#include "eval/report/figure_success.h"
#include "eval/report/figure_trunks.h"
#include "eval/run/localization_figures.h"
#include "eval/run/paper_li2020.h"

namespace honka::eval {
namespace {

/// Rows of the default variant with so many frames, and where `flag` is 1 if one is named.
std::vector<std::size_t> default_rows(const Table& table, std::int64_t frames,
                                      const char* flag = nullptr) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool wanted =
        table.strings("variant")[row] == "default" && table.ints("frames")[row] == frames;
    if (wanted && (flag == nullptr || table.ints(flag)[row] == 1)) rows.push_back(row);
  }
  return rows;
}

/// A column of these rows, each value times `scale`.
std::vector<double> column(const Table& table, const std::vector<std::size_t>& rows,
                           const char* name, double scale = 1.0) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(scale * table.doubles(name)[row]);
  return values;
}

std::vector<std::int64_t> frame_numbers(const std::vector<LocalizationSummary>& summaries) {
  std::vector<std::int64_t> numbers;
  for (const auto& summary : summaries) {
    if (summary.variant == "default") numbers.push_back(summary.frames);
  }
  return numbers;
}

/// "prior run" for "prior_run".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string n_windows(const std::vector<LocalizationSummary>& summaries) {
  const auto& first = summaries.front();
  return fmt::format("{} disjoint windows, map of the {}, tolerance {} m²", first.windows,
                     spoken(first.map), first.tolerance_m2);
}

ReportFigure success(const std::filesystem::path& folder,
                     const std::vector<LocalizationSummary>& summaries) {
  SuccessFigure figure;
  figure.protocol = n_windows(summaries) + "; Wilson intervals, 95 %";
  for (const LocalizationSummary& s : summaries) {
    const bool other = s.method != summaries.front().method;
    const bool shown = s.variant == "default" || s.variant == "same_run" || s.variant == "repaired";
    if (!shown && !other) continue;
    const std::string label = other ? s.method + (s.repaired ? ", repaired chain" : "")
                              : s.variant == "default" ? "map of the " + spoken(s.map)
                              : s.variant == "same_run"
                                  ? "map of the same run"
                                  : "repaired chain, map of the " + spoken(s.map);
    if (figure.series.empty() || figure.series.back().label != label) {
      figure.series.push_back({label, {}});
    }
    figure.series.back().points.push_back(
        {s.frames, s.success_rate(), s.success_interval.low, s.success_interval.high});
  }
  for (const std::int64_t frames : frame_numbers(summaries)) {
    if (const auto paper = paper_row(frames)) {
      figure.paper.push_back({frames, paper->success_rate, 0, 0});
    }
  }
  return draw_success(folder, figure);
}

WindowCountsFigure counts(const Table& table, const std::vector<LocalizationSummary>& summaries,
                          const char* name, double PaperRow::*member) {
  WindowCountsFigure figure;
  figure.protocol = n_windows(summaries);
  for (const std::int64_t frames : frame_numbers(summaries)) {
    WindowCounts series;
    series.frames = frames;
    for (const std::size_t row : default_rows(table, frames)) {
      series.counts.push_back(static_cast<double>(table.ints(name)[row]));
    }
    if (const auto paper = paper_row(frames)) series.paper_mean = (*paper).*member;
    figure.series.push_back(std::move(series));
  }
  return figure;
}

ReportFigure accuracy(const std::filesystem::path& folder, const Table& table,
                      const std::vector<LocalizationSummary>& summaries) {
  AccuracyFigure figure;
  figure.protocol = n_windows(summaries) + "; successes only";
  for (const std::int64_t frames : frame_numbers(summaries)) {
    AccuracySeries series;
    series.frames = frames;
    const auto rows = default_rows(table, frames, "success");
    series.rotation_error_deg = column(table, rows, "rotation_error_rad", rad_to_deg(1.0));
    series.match_time_s = column(table, rows, "match_ms", 1e-3);
    series.map_time_s = column(table, rows, "aggregate_ms", 1e-3);
    const auto extract_s = column(table, rows, "extract_ms", 1e-3);
    for (std::size_t i = 0; i < rows.size(); ++i) series.map_time_s[i] += extract_s[i];
    figure.series.push_back(std::move(series));
  }
  return draw_accuracy(folder, figure);
}

ReportFigure errors(const std::filesystem::path& folder, const Table& table,
                    const std::vector<LocalizationSummary>& summaries) {
  ErrorsFigure figure;
  figure.protocol = n_windows(summaries) + "; accepted answers";
  for (const std::int64_t frames : frame_numbers(summaries)) {
    ErrorSeries series;
    series.frames = frames;
    const auto rows = default_rows(table, frames, "accepted");
    series.to_truth_m = column(table, rows, "translation_error_m");
    series.to_odometry_m = column(table, rows, "error_to_odometry_m");
    figure.series.push_back(std::move(series));
  }
  return draw_errors(folder, figure);
}

ReportFigure recall(const std::filesystem::path& folder,
                    const std::vector<LocalizationSummary>& summaries,
                    const std::vector<DetectionSummary>& detection) {
  StemRecallFigure figure;
  figure.protocol =
      fmt::format("{} windows; trees in view count, hidden ones too", summaries.front().windows);
  const auto share = [](std::int64_t part, std::int64_t whole) {
    return whole == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(whole);
  };
  for (const DetectionSummary& summary : detection) {
    if (summary.variant != "default") continue;
    StemRecallSeries series{fmt::format("C{}", summary.frames), {}};
    for (const auto& bin : summary.bins) {
      series.bins.push_back({bin.low_m, bin.high_m, share(bin.trees_found, bin.trees),
                             share(bin.found_true, bin.found)});
    }
    figure.series.push_back(std::move(series));
  }
  return draw_stem_recall(folder, figure);
}

ReportFigure speed(const std::filesystem::path& folder,
                   const std::vector<LocalizationSummary>& summaries) {
  SpeedFigure figure;
  figure.protocol = "a key frame comes every p95 of the online time; one core";
  for (const LocalizationSummary& s : summaries) {
    if (s.variant != "default" && s.variant != "repaired") continue;
    figure.rows.push_back({fmt::format("C{}, {}", s.frames, s.variant), s.keeps_up_m_s});
  }
  return draw_speed(folder, figure);
}

}  // namespace

std::vector<ReportFigure> draw_statistics(const std::filesystem::path& folder, const Table& frames,
                                          const std::vector<LocalizationSummary>& summaries,
                                          const std::vector<DetectionSummary>& detection) {
  if (summaries.empty()) return {};
  return {success(folder, summaries),
          draw_trunks(folder, counts(frames, summaries, "stems", &PaperRow::trunks)),
          draw_matches(folder, counts(frames, summaries, "matches", &PaperRow::matching_triangles)),
          accuracy(folder, frames, summaries),
          errors(folder, frames, summaries),
          recall(folder, summaries, detection),
          speed(folder, summaries)};
}

}  // namespace honka::eval
