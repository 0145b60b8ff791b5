#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/run/slam/slam_tables.h"

namespace honka::eval {
namespace {

Json value_json(const SeedFigure& figure) {
  return figure.values.empty() ? Json() : Json(figure.mean_or_nan());
}

Json interval_json(const SeedFigure& figure) {
  const auto interval = figure.interval();
  return interval ? Json::array({interval->low, interval->high}) : Json();
}

/// `key` and `key`_interval.
void put_figure(Json& row, const std::string& key, const SeedFigure& figure) {
  row[key] = value_json(figure);
  row[key + "_interval"] = interval_json(figure);
}

void put_seeds(Json& row, const SlamSummaryRow& s) {
  row["seeds"] = s.done;
  row["of"] = s.trials;
}

Json paper_json(const PaperSlamRow& paper) {
  Json row = {{"blur", paper.blur}};
  if (paper.cluster_rmse_m) row["cluster_rmse_m"] = *paper.cluster_rmse_m;
  if (paper.corrections) row["corrections"] = *paper.corrections;
  return row;
}

Json table1_row(const SlamSummaryRow& s, bool beside_paper) {
  Json row;
  row["start"] = s.start;
  row["order"] = s.treatment;
  put_figure(row, "blur", s.blur);
  put_figure(row, "blur_floor", s.blur_floor);
  put_figure(row, "cluster_rmse_m", s.cluster_rmse_m);
  put_figure(row, "cluster_rmse_floor_m", s.cluster_rmse_floor_m);
  put_figure(row, "ate_m", s.ate_m);
  put_figure(row, "ate_planar_m", s.ate_planar_m);
  put_figure(row, "corrections", s.corrections);
  put_figure(row, "go_icp_calls", s.go_icp_calls);
  put_figure(row, "cluster_rmse_05_m", s.cluster_rmse_05_m);
  put_figure(row, "box_dimension", s.box_dimension);
  put_seeds(row, s);
  const PaperSlamRow* paper = beside_paper ? paper_slam_row(s.treatment) : nullptr;
  if (paper != nullptr) row["paper"] = paper_json(*paper);
  return row;
}

Json methods_row(const SlamSummaryRow& s) {
  Json row;
  row["start"] = s.start;
  row["method"] = s.treatment;
  put_figure(row, "blur", s.blur);
  put_figure(row, "blur_floor", s.blur_floor);
  put_figure(row, "ate_m", s.ate_m);
  put_figure(row, "ate_planar_m", s.ate_planar_m);
  put_figure(row, "cluster_rmse_05_m", s.cluster_rmse_05_m);
  put_figure(row, "cluster_rmse_05_floor_m", s.cluster_rmse_05_floor_m);
  put_figure(row, "cluster_rmse_m", s.cluster_rmse_m);
  put_figure(row, "cluster_rmse_floor_m", s.cluster_rmse_floor_m);
  put_figure(row, "corrections", s.corrections);
  put_figure(row, "time_s", s.time_s);
  put_seeds(row, s);
  return row;
}

void name_columns(SummaryTable& table) {
  if (table.rows.empty()) return;
  for (const auto& item : table.rows.front().items()) {
    if (item.key() != "paper") table.columns.push_back(item.key());
  }
}

}  // namespace

SummaryTable slam_table1_json(const std::vector<SlamSummaryRow>& rows, const Scenario& scenario) {
  SummaryTable table;
  for (const SlamSummaryRow& row : rows) {
    table.rows.push_back(table1_row(row, row.start == rows.front().start));
  }
  name_columns(table);
  for (const PaperSlamRow& paper : paper_slam_rows()) {
    table.paper[paper.treatment] = paper_json(paper);
  }
  table.protocol = fmt::format("{}", fmt::join(slam_protocol(scenario), " "));
  return table;
}

SummaryTable slam_methods_json(const std::vector<SlamSummaryRow>& rows, const Scenario& scenario) {
  SummaryTable table;
  for (const SlamSummaryRow& row : rows) table.rows.push_back(methods_row(row));
  name_columns(table);
  table.protocol = fmt::format("{}", fmt::join(slam_protocol(scenario), " "));
  return table;
}

}  // namespace honka::eval
