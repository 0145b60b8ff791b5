#include "eval/run/slam/link_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace honka::eval {
namespace {

/// Nevalainen2021 §2.1: 3.7 GB of packets over a strip road of 130 m.
constexpr double kPaperRaw_MB_per_m = 28.0;
constexpr double kPaperStems = 130.0;

/// Sums of the needs of several trials.
LinkNeed summed_need(const std::vector<LinkTrial>& trials) {
  LinkNeed sum;
  for (const LinkTrial& trial : trials) {
    sum.key_frames += trial.need.key_frames;
    sum.stems += trial.need.stems;
    sum.duration_s += trial.need.duration_s;
    sum.length_m += trial.need.length_m;
    sum.message_bytes += trial.need.message_bytes;
    sum.air_bytes += trial.need.air_bytes;
    sum.raw_bytes += trial.need.raw_bytes;
  }
  return sum;
}

std::string value_text(const LinkCase& link) {
  if (link.series == "delay") return fmt::format("{:g} s", link.value);
  return fmt::format("{:g} %", 100.0 * link.value);
}

/// "0.034 / 0.026": ours beside the floor, or beside another figure.
std::string over_floor(const LinkScores& s, const LinkScores::Figure& ours,
                       const LinkScores::Figure& floor, int decimals) {
  return fixed(s.mean_of(ours), decimals) + " / " + fixed(s.mean_of(floor), decimals);
}

std::vector<ReportHeader> series_headers(const std::string& series) {
  std::vector<ReportHeader> headers = {{series == "bandwidth" ? "bandwidth of the need" : series},
                                       {series == "loss" ? "pattern" : "edge sends"},
                                       {"method"},
                                       {"sent", "kB/m"},
                                       {"frames arrived"}};
  if (series == "delay") headers.push_back({"late"});
  headers.insert(headers.end(), {{"age p50 / p95", "s"},
                                 {"behind", "m"},
                                 {"β / floor"},
                                 {"cluster RMSE / floor", "m"},
                                 {"ATE / in plan", "m"},
                                 {"stems mapped / floor"},
                                 {"false"},
                                 {"stem RMSE", "m"}});
  return headers;
}

std::string mean_text(const LinkScores& s, const LinkScores::Figure& figure, int decimals) {
  return fixed(s.mean_of(figure), decimals);
}

/// The link, and what came through it.
std::vector<ReportCell> link_cells(const LinkScores& s) {
  const auto mean = [&](const LinkScores::Figure& figure, int decimals) {
    return mean_text(s, figure, decimals);
  };
  std::vector<ReportCell> row = {
      {value_text(s.link)},
      {s.link.variant},
      {s.method},
      {mean([](const auto& r) { return 1e-3 * r.sent_bytes_per_m(); }, 2)},
      {mean([](const auto& r) { return double(r.tally.arrived); }, 0)}};
  if (s.link.series == "delay") {
    row.push_back({mean([](const auto& r) { return double(r.tally.late); }, 0)});
  }
  row.push_back({mean([](const auto& r) { return r.tally.age_p50_s; }, 1) + " / " +
                 mean([](const auto& r) { return r.tally.age_p95_s; }, 1)});
  row.push_back({mean([](const auto& r) { return r.tally.behind_m; }, 1)});
  return row;
}

/// The map; its status where there is none.
std::vector<ReportCell> map_cells(const LinkScores& s) {
  if (s.mapped() == 0) return {{s.trials.front().status}, {"–"}, {"–"}, {"–"}, {"–"}, {"–"}};
  return {{over_floor(
              s, [](const auto& r) { return r.quality.blur; },
              [](const auto& r) { return r.floor.blur; }, 4)},
          {over_floor(
              s, [](const auto& r) { return r.quality.cluster_rmse_m; },
              [](const auto& r) { return r.floor.cluster_rmse_m; }, 3)},
          {over_floor(
              s, [](const auto& r) { return r.quality.ate_m; },
              [](const auto& r) { return r.quality.ate_planar_m; }, 3)},
          {over_floor(
              s, [](const auto& r) { return double(r.quality.stems_mapped); },
              [](const auto& r) { return double(r.floor.stems_mapped); }, 0)},
          {mean_text(
              s, [](const auto& r) { return double(r.quality.stems_false); }, 0)},
          {mean_text(
              s, [](const auto& r) { return r.quality.stem_rmse_m; }, 3)}};
}

std::vector<ReportCell> series_row(const LinkScores& s) {
  std::vector<ReportCell> row = link_cells(s);
  for (ReportCell& cell : map_cells(s)) row.push_back(std::move(cell));
  return row;
}

}  // namespace

std::vector<std::string> link_protocol() {
  return {
      "Messages: one a key frame; stems as three 16-bit centimetres, the edge's pose, a header and "
      "a checksum: 38 bytes and 6 a stem. No message is sent again.",
      "The need: all key frames of the drive, 28 bytes of UDP and IPv4 on each included, over its "
      "whole duration.",
      "Edge policies: paced sends an even part of the key frames, as large as the radio can carry "
      "without letting a message wait longer than link.edge.longest_wait_s; all gives every key "
      "frame to the radio, whose queue of link.queue_bytes drops the oldest or the newest.",
      "The cloud maps what had arrived when the last key frame was taken: what is late is missing.",
      "Age: from the key frame to its arrival. Behind: the way driven since the newest key frame "
      "that had arrived, mean over the key frames.",
      fmt::format("Floors: the same frames at their true poses. β (Nevalainen2021 Eq. 30) and the "
                  "cluster RMSE (link 0.5 m, at least 15 points) fall with the number of frames; "
                  "compare them with their floors alone. ATE: RMSE of the arrived frames' "
                  "positions after rigid alignment, and of their x and y. Mapped: true stems "
                  "within {} m of a stem of "
                  "the map so aligned; false: stems of the map without one.",
                  kMappedStemGate_m),
      "All links of a drive have the same chances: what is lost at 10 % is lost at 20 % too.",
  };
}

ReportTable link_need_table(const std::vector<LinkTrial>& trials) {
  const LinkNeed need = summed_need(trials);
  const auto n = static_cast<double>(trials.size());
  ReportTable table;
  table.title = "What the edge has to say";
  table.protocol = fmt::format("{:.0f} m and {:.0f} s a drive, mean over drives: {}",
                               need.length_m / n, need.duration_s / n, trials.size());
  table.headers = {{"what"}, {"a metre", "kB"}, {"a second", "kB"}};
  const auto row = [&](const std::string& what, double bytes, std::optional<double> paper) {
    table.rows.push_back({{what},
                          compared(1e-3 * bytes / need.length_m, paper, 2),
                          {fixed(1e-3 * bytes / need.duration_s, 2)}});
  };
  row("raw packets of the lidar", need.raw_bytes, 1e3 * kPaperRaw_MB_per_m);
  row("stems of all key frames", need.message_bytes, std::nullopt);
  row("the same on the air", need.air_bytes, std::nullopt);
  const double frames = static_cast<double>(need.key_frames);
  table.notes.push_back(fmt::format(
      "{:.0f} key frames a drive with {:.1f} stems each (the paper: {:.0f}); messages are 1/{:.0f} "
      "of the packets.",
      frames / n, static_cast<double>(need.stems) / frames, kPaperStems,
      need.raw_bytes / need.message_bytes));
  return table;
}

ReportTable link_series_table(const std::string& series, const std::vector<LinkScores>& scores) {
  ReportTable table;
  table.title = "Map quality by " + series;
  table.protocol = fmt::format("mean over drives: {}; the map when the drive ended",
                               scores.empty() ? 0 : scores.front().trials.size());
  table.headers = series_headers(series);
  for (const LinkScores& s : scores) {
    if (s.link.series == series) table.rows.push_back(series_row(s));
  }
  return table;
}

}  // namespace honka::eval
