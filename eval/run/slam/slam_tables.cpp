#include "eval/run/slam/slam_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace honka::eval {
namespace {

/// "0.071 [0.065, 0.080]", and the paper's figure where it has one.
ReportCell seeds_cell(const SeedFigure& figure, int decimals, std::optional<double> paper = {}) {
  ReportCell cell = compared(figure.mean_or_nan(), paper, decimals);
  if (const auto interval = figure.interval()) {
    cell.text +=
        fmt::format(" [{}, {}]", fixed(interval->low, decimals), fixed(interval->high, decimals));
  }
  return cell;
}

ReportCell mean_cell(const SeedFigure& figure, int decimals) {
  return {fixed(figure.mean_or_nan(), decimals)};
}

ReportCell n_of(const SlamSummaryRow& row) {
  return {fmt::format("{} of {}", row.done, row.trials)};
}

std::string percent_text(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) : "–";
}

std::string root_text(double sum, std::int64_t count) {
  return count > 0 ? fixed(std::sqrt(sum / static_cast<double>(count)), 3) : "–";
}

/// Blur of a start and order, by trial; NaN where it is missing.
std::vector<double> blur_of(const std::vector<SlamTrial>& trials, const std::string& start,
                            const std::string& treatment) {
  std::vector<double> values;
  for (const SlamTrial& trial : trials) {
    for (const SlamRun& run : trial.runs) {
      if (run.start == start && run.treatment == treatment) values.push_back(run.quality.blur);
    }
  }
  return values;
}

std::vector<std::string> starts_in(const std::vector<SlamTrial>& trials) {
  std::vector<std::string> starts;
  for (const SlamTrial& trial : trials) {
    for (const SlamRun& run : trial.runs) {
      if (starts.empty() || starts.back() != run.start) starts.push_back(run.start);
    }
    if (!starts.empty()) break;
  }
  return starts;
}

}  // namespace

std::vector<std::string> slam_protocol(const Scenario& scenario) {
  return {
      "Figures are means over the seeds that have them; in brackets the 95 % percentile bootstrap "
      "of the mean over seeds. A seed is another stand, road, drive and noise.",
      "Blur: Nevalainen2021 Eq. 30, grids of 0.2 and 10 m in the plane, over the points of all key "
      "frames. Map noise e_C: RMSE of the points of a tree's cluster from their mean, the mean "
      "over "
      "clusters; points are linked up to 1.0 m (an alpha shape of 0.5 m) or 0.5 m.",
      "Floor: the same figure of the same points at the true poses; a perfect path leaves it.",
      "ATE: RMSE of the positions of all key frames after the rigid transform that brings them "
      "nearest to the truth.",
      fmt::format("Chains: trimmed ICP from frame to frame with the inlier ratio in their name. "
                  "Re-registered: the chain of ratio {} with each step registered and verified "
                  "again. Orders: one pass of the paper's loop over at most {} chosen pairs; the "
                  "same candidate pairs for every order of a start.",
                  scenario.slam.chain.inlier_ratio, scenario.slam.loop.corrections),
      "The methods get key frames' stems and, as start, poses made of them; truth enters the "
      "figures alone.",
  };
}

ReportTable slam_table1(const std::vector<SlamSummaryRow>& rows) {
  ReportTable table;
  table.title = "Table 1: three starts, three orders of correction";
  table.protocol =
      "blur Eq. 30; noise: mean RMSE of clusters, link 1.0 m; floor: same points at true poses; "
      "ATE after rigid alignment; means over seeds [95 %]";
  table.headers = {{"start"},       {"order"},        {"blur"},     {"blur floor"},
                   {"noise", "m"},  {"floor", "m"},   {"ATE", "m"}, {"in plan", "m"},
                   {"corrections"}, {"Go-ICP calls"}, {"seeds"}};
  for (const SlamSummaryRow& row : rows) {
    const PaperSlamRow* paper = paper_slam_row(row.treatment);
    const auto none = std::optional<double>();
    // The paper has one start; its figures stand at ours that has its blur.
    const bool beside = paper != nullptr && row.start == rows.front().start;
    table.rows.push_back({{row.start},
                          {row.treatment},
                          seeds_cell(row.blur, 3, beside ? std::optional(paper->blur) : none),
                          mean_cell(row.blur_floor, 3),
                          seeds_cell(row.cluster_rmse_m, 3, beside ? paper->cluster_rmse_m : none),
                          mean_cell(row.cluster_rmse_floor_m, 3),
                          seeds_cell(row.ate_m, 2),
                          mean_cell(row.ate_planar_m, 2),
                          seeds_cell(row.corrections, 0, beside ? paper->corrections : none),
                          mean_cell(row.go_icp_calls, 0),
                          n_of(row)});
  }
  table.notes.push_back("The paper's figures stand beside the first start, the one made like its.");
  return table;
}

ReportTable slam_methods_table(const std::vector<SlamSummaryRow>& rows) {
  ReportTable table;
  table.title = "Methods on the same frames";
  table.protocol =
      "blur Eq. 30; noise: mean RMSE of clusters; floor: same points at true poses; ATE after "
      "rigid "
      "alignment; time without the start's, others at work beside; means over seeds [95 %]";
  table.headers = {{"start"},          {"method"},       {"blur"},           {"floor"},
                   {"ATE", "m"},       {"in plan", "m"}, {"noise 0.5", "m"}, {"floor", "m"},
                   {"noise 1.0", "m"}, {"floor", "m"},   {"corrections"},    {"time", "s"},
                   {"seeds"}};
  for (const SlamSummaryRow& row : rows) {
    table.rows.push_back({{row.start},
                          {row.treatment},
                          seeds_cell(row.blur, 3),
                          mean_cell(row.blur_floor, 3),
                          seeds_cell(row.ate_m, 3),
                          mean_cell(row.ate_planar_m, 3),
                          seeds_cell(row.cluster_rmse_05_m, 3),
                          mean_cell(row.cluster_rmse_05_floor_m, 3),
                          seeds_cell(row.cluster_rmse_m, 3),
                          mean_cell(row.cluster_rmse_floor_m, 3),
                          mean_cell(row.corrections, 0),
                          mean_cell(row.time_s, 2),
                          n_of(row)});
  }
  return table;
}

ReportTable slam_details_table(const std::vector<SlamSummaryRow>& rows) {
  ReportTable table;
  table.title = "Further figures";
  table.protocol = "means over seeds";
  table.headers = {{"start"},
                   {"treatment"},
                   {"noise pooled", "m"},
                   {"noise 0.5", "m"},
                   {"floor", "m"},
                   {"box dimension"},
                   {"floor"},
                   {"ATE", "deg"},
                   {"ICP calls"},
                   {"ICP a call", "ms"},
                   {"Go-ICP a call", "ms"},
                   {"time", "s"}};
  for (const SlamSummaryRow& row : rows) {
    table.rows.push_back({{row.start},
                          {row.treatment},
                          mean_cell(row.pooled_rmse_m, 3),
                          mean_cell(row.cluster_rmse_05_m, 3),
                          mean_cell(row.cluster_rmse_05_floor_m, 3),
                          mean_cell(row.box_dimension, 2),
                          mean_cell(row.box_dimension_floor, 2),
                          mean_cell(row.ate_deg, 2),
                          mean_cell(row.icp_calls, 0),
                          mean_cell(row.icp_ms, 2),
                          mean_cell(row.go_icp_ms, 2),
                          mean_cell(row.time_s, 2)});
  }
  return table;
}

ReportTable slam_orders_table(const std::vector<SlamTrial>& trials) {
  ReportTable table;
  table.title = "Does the order matter?";
  table.protocol =
      "blur of an order less that of small-gaps-first on the same seed; mean [95 % bootstrap over "
      "seeds]; an interval that holds 0 shows no difference";
  table.headers = {{"start"}, {"order"}, {"difference of blur"}, {"seeds"}};
  for (const std::string& start : starts_in(trials)) {
    const auto small = blur_of(trials, start, "small_gaps_first");
    for (const std::string order : {"medium_gaps_first", "random"}) {
      const auto other = blur_of(trials, start, order);
      if (other.size() != small.size()) continue;
      const auto difference = paired_difference(other, small);
      if (!difference) continue;
      std::string text = fmt::format("{:+.4f}", difference->mean);
      if (difference->interval) {
        text += fmt::format(" [{:+.4f}, {:+.4f}]", difference->interval->low,
                            difference->interval->high);
      }
      table.rows.push_back({{start}, {order}, {text}, {std::to_string(difference->n)}});
    }
  }
  return table;
}

ReportTable slam_drives_table(const std::vector<SlamTrial>& trials) {
  ReportTable table;
  table.title = "The drives";
  table.protocol =
      "recall: of all true stems in the view cones, hidden ones too; position error: RMSE of each "
      "horizontal component, and of the height, of stems with a true one within the gate";
  table.headers = {{"trial"},
                   {"trees on the strip"},
                   {"sweeps"},
                   {"not registered"},
                   {"key frames"},
                   {"stems a frame"},
                   {"in view"},
                   {"precision", "%"},
                   {"recall", "%"},
                   {"position error", "m"},
                   {"height error", "m"},
                   {"edge ATE", "m"}};
  for (const SlamTrial& trial : trials) {
    const FrameScores& s = trial.stems;
    const auto a_frame = [&](std::int64_t count) {
      return s.frames > 0 ? static_cast<double>(count) / static_cast<double>(s.frames)
                          : std::numeric_limits<double>::quiet_NaN();
    };
    const double edge_m = trial.drive.frames.empty()
                              ? std::numeric_limits<double>::quiet_NaN()
                              : judge_slam(trial.drive, trial.drive.edge_T_first_frame, {}).ate_m;
    table.rows.push_back({{std::to_string(trial.trial)},
                          compared(static_cast<double>(trial.drive.trees_on_strip), 680.0, 0),
                          compared(static_cast<double>(trial.drive.sweeps), 9009.0, 0),
                          {std::to_string(trial.drive.unregistered_sweeps)},
                          compared(static_cast<double>(trial.drive.frames.size()), 2800.0, 0),
                          compared(a_frame(s.found), 130.0, 1),
                          {fixed(a_frame(s.truth), 1)},
                          {percent_text(s.found_matched, s.found)},
                          {percent_text(s.truth_matched, s.truth)},
                          {root_text(0.5 * s.planar_m2, s.found_matched)},
                          {root_text(s.height_m2, s.found_matched)},
                          {fixed(edge_m, 2)}});
  }
  return table;
}

}  // namespace honka::eval
