#include "eval/run/localize/map_update_figures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

using Places = std::vector<Eigen::Vector2d>;

Places with_fate(const JudgedMap& map, StemFate fate) {
  Places places_m;
  for (const JudgedStem& stem : map.stems) {
    if (stem.seen && stem.fate == fate) places_m.push_back(stem.place_m);
  }
  return places_m;
}

/// How a fate is drawn, and what the legend calls it.
struct FateStyle {
  StemFate fate;
  const char* name;
  std::string style;
};

std::vector<FateStyle> fate_styles() {
  return {
      {StemFate::kKept, "in the map, stands", std::string("pt 7 ps 0.35 lc ") + kGrey},
      {StemFate::kStale, "in the map, felled", std::string("pt 7 ps 0.45 lc ") + kOrange},
      {StemFate::kRetired, "retired, felled", "pt 6 ps 0.4 lw 0.9 lc '#A8A8A8'"},
      {StemFate::kWronglyRetired, "retired, but stands",
       std::string("pt 2 ps 1.2 lw 2 lc ") + kRed},
      {StemFate::kAdded, "added, stands", std::string("pt 7 ps 0.5 lc ") + kBlue},
      {StemFate::kFalselyAdded, "added, no tree", std::string("pt 8 ps 0.75 lw 2 lc ") + kPink}};
}

void plot_panel(Figure& figure, const JudgedMap& map, const std::string& title) {
  figure << "set title " + gnuplot_text(title) + " font ',12'";
  std::vector<std::string> elements;
  for (const FateStyle& one : fate_styles()) {
    const Places places_m = with_fate(map, one.fate);
    if (places_m.empty()) continue;
    elements.push_back(figure.data(one.name, places_m) + " with points " + one.style + " title " +
                       gnuplot_text(fmt::format("{} ({})", one.name, places_m.size())));
  }
  elements.push_back(
      figure.data("standing trees that the map lacks", map.unmapped_m) +
      " with points pt 4 ps 0.6 lw 1.4 lc " + kGreen + " title " +
      gnuplot_text(fmt::format("stands, not in the map ({})", map.unmapped_m.size())));
  figure.plot(elements);
}

constexpr const char* kOldMap = "old map";
constexpr const char* kNewMap = "new map";

std::string curve_name(const MapUpdateAnswer& a) {
  if (a.map == "updated") return "updated by " + a.fed_by;
  return a.map == "old" ? kOldMap : kNewMap;
}

constexpr std::size_t kStretches = 20;

/// Successes and lists of each twentieth of a drive.
using Stretches = std::array<Block, kStretches>;
/// By method, then map.
using Curves = std::map<std::string, std::map<std::string, Stretches>>;

Curves drive_curves(const std::vector<MapUpdateDrive>& drives, double thinned_to_per_ha) {
  Curves curves;
  for (const MapUpdateDrive& drive : drives) {
    if (drive.thinned_to_per_ha != thinned_to_per_ha) continue;
    for (const MapUpdateAnswer& a : drive.answers) {
      const std::size_t at = static_cast<std::size_t>(a.list) * kStretches / drive.road.size();
      Block& block = curves[a.method][curve_name(a)][at];
      block.sum += a.success ? 1.0 : 0.0;
      block.count += 1.0;
    }
  }
  return curves;
}

/// The middle of each stretch, metres, and its rate, %.
std::vector<std::vector<double>> curve_columns(const Stretches& stretches, double drive_m) {
  std::vector<std::vector<double>> columns(2);
  for (std::size_t i = 0; i < kStretches; ++i) {
    if (stretches[i].count == 0.0) continue;
    columns[0].push_back((static_cast<double>(i) + 0.5) * drive_m / kStretches);
    columns[1].push_back(100.0 * stretches[i].sum / stretches[i].count);
  }
  return columns;
}

std::string curve_style(const std::string& map_name) {
  const auto style = [](const char* point, double width, const std::string& colour) {
    return fmt::format(" with linespoints pt {} ps 0.6 lw {} lc {}", point, width, colour);
  };
  if (map_name == kOldMap) return style("6", 4.0, "'#C4C4C4'");  // wide: others lie on it
  if (map_name == kNewMap) return style("4", 1.6, kBlack);
  return map_name == "updated by consensus" ? style("7", 2.4, kBlue) : style("9", 1.6, kOrange);
}

ReportFigure draw_one_success(const std::filesystem::path& folder, const Scenario& scenario,
                              const std::vector<MapUpdateDrive>& drives, double thinned_to_per_ha) {
  const Curves curves = drive_curves(drives, thinned_to_per_ha);
  const double drive_m =
      scenario.map_update.view_every_m * static_cast<double>(drives.front().road.size());
  Figure figure(folder, fmt::format("success_along_drive_{:.0f}", thinned_to_per_ha), 1100, 520);
  figure << fmt::format("set multiplot layout 1,{} title {} font ',14'", curves.size(),
                        gnuplot_text(fmt::format("Success along the drive, thinned to {:.0f}/ha",
                                                 thinned_to_per_ha)))
         << "set yrange [0:104]"
         << "set xrange [0:" + number(drive_m) + "]"
         << "set xlabel 'way driven (m)'"
         << "set bmargin 7"
         << "set key horizontal at graph 0.5, screen 0.07 center maxcols 2";
  for (std::int64_t pass = 1; pass < scenario.map_update.passes; ++pass) {
    const std::string at = number(drive_m * static_cast<double>(pass) /
                                  static_cast<double>(scenario.map_update.passes));
    figure << "set arrow from " + at + ", graph 0 to " + at + ", graph 1 nohead dt 3 lc '#666666'";
  }
  for (const auto& [method, by_map] : curves) {
    figure << "set title " + gnuplot_text(method) << "set ylabel 'success (% of lists)'";
    std::vector<std::string> elements;
    for (const auto& [map_name, stretches] : by_map) {
      elements.push_back(figure.data(method + ", " + map_name + ": way m, success %",
                                     curve_columns(stretches, drive_m)) +
                         curve_style(map_name) + " title " + gnuplot_text(map_name));
    }
    figure.plot(elements);
  }
  figure << "unset multiplot";
  return figure.draw(
      fmt::format("Success along the drive, thinned to {:.0f}/ha", thinned_to_per_ha),
      "Share of the lists of each twentieth of the drive that are accepted and right, by the map "
      "they are asked in. Dotted: the next pass begins.");
}

}  // namespace

ReportFigure draw_map_before_after(const std::filesystem::path& folder,
                                   const MapUpdateExhibit& exhibit) {
  Figure figure(folder, "map_before_after", 1200, 980);
  figure << "set multiplot layout 1,2 title " +
                gnuplot_text(fmt::format("The map before and after the drive, thinned to {:.0f}/ha",
                                         exhibit.thinned_to_per_ha)) +
                " font ',14'"
         << "set size ratio -1"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'"
         << "set bmargin 10"
         << "set key at graph 0.5, screen 0.055 center maxcols 2";
  plot_panel(figure, exhibit.before, "before: the old map against the thinned stand");
  plot_panel(figure, exhibit.after, "after: updated by " + exhibit.after.quality.fed_by);
  figure << "unset multiplot";
  return figure.draw("The map before and after the drive",
                     "Stems of the map against the trees that stand, within the area seen. "
                     "Colours by truth, which neither matcher nor updater sees.");
}

std::vector<ReportFigure> draw_success_along_drive(const std::filesystem::path& folder,
                                                   const Scenario& scenario,
                                                   const std::vector<MapUpdateDrive>& drives) {
  std::vector<ReportFigure> figures;
  for (const double density : scenario.map_update.thinned_to_per_ha) {
    figures.push_back(draw_one_success(folder, scenario, drives, density));
  }
  return figures;
}

ReportFigure draw_map_quality(const std::filesystem::path& folder,
                              const std::vector<MapQualitySummary>& summaries) {
  std::map<std::string, std::vector<std::vector<double>>> curves;
  for (const MapQualitySummary& s : summaries) {
    const MapQuality& q = s.sum;
    auto& columns = curves[fmt::format("{:.0f}/ha, {}", s.thinned_to_per_ha, q.fed_by)];
    columns.resize(4);
    const auto percent = [](std::int64_t n, std::int64_t of) {
      return of == 0 ? NAN : 100.0 * static_cast<double>(n) / static_cast<double>(of);
    };
    columns[0].push_back(static_cast<double>(q.part));
    columns[1].push_back(percent(q.seen_true, q.seen_stems));
    columns[2].push_back(percent(q.seen_trees_mapped, q.seen_trees));
    columns[3].push_back(percent(q.felled_retired, q.felled));
  }
  Figure figure(folder, "map_quality", 1100, 440);
  figure << "set multiplot layout 1,3 title 'The map against the trees that stand' font ',14'"
         << "set yrange [0:104]"
         << "set xrange [-0.2:" + number(static_cast<double>(kDriveParts) + 0.2) + "]"
         << "set xlabel 'quarters driven'"
         << "set xtics 1"
         << "set key bottom right";
  const std::pair<const char*, const char*> kPanels[] = {
      {"precision", "1:2"}, {"recall", "1:3"}, {"felled stems retired", "1:4"}};
  for (const auto& [name, columns] : kPanels) {
    figure << fmt::format("set title '{}'", name) << fmt::format("set ylabel '{} (%)'", name);
    std::vector<std::string> elements;
    for (const auto& [label, values] : curves) {
      const std::size_t i = elements.size();
      elements.push_back(figure.data(label, values) + " using " + columns +
                         " with linespoints lw 1.8 ps 0.8 pt " + series_point(i) + " lc " +
                         series_colour(i) + " title " + gnuplot_text(label));
    }
    figure.plot(elements);
  }
  figure << "unset multiplot";
  return figure.draw("The map against the trees that stand",
                     "Within the area seen so far; before the drive (0), within what the whole "
                     "drive sees. By the matcher whose accepted poses updated the map.");
}

}  // namespace honka::eval
