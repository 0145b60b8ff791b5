#include "eval/run/slam/selection_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

double percent_of(std::int64_t part, std::size_t whole) {
  return whole == 0 ? std::nan("") : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

struct SelectionColumn {
  const char *name, *title, *unit;
  int decimals;
  std::optional<double> paper;
  double (*of)(const SelectionCase&);
};

const SelectionColumn kSelectionColumns[] = {
    {"pairs_tried", "pairs tried", "", 0, 1870000.0,
     [](const SelectionCase& c) { return static_cast<double>(c.found.tried); }},
    {"pairs_judged",
     "overlapping",
     "",
     0,
     {},
     [](const SelectionCase& c) { return static_cast<double>(c.judged()); }},
    {"promising", "promising, I2", "", 0, 3500.0,
     [](const SelectionCase& c) { return static_cast<double>(c.found.promising.size()); }},
    {"promising_percent", "of those tried", "%", 1, 0.2,
     [](const SelectionCase& c) {
       return percent_of(static_cast<std::int64_t>(c.found.promising.size()),
                         static_cast<std::size_t>(c.found.tried));
     }},
    {"promising_right_percent",
     "promising and right",
     "%",
     1,
     {},
     [](const SelectionCase& c) {
       return percent_of(c.promising_right, c.found.promising.size());
     }},
    {"inferior_right_percent",
     "inferior yet right",
     "%",
     1,
     {},
     [](const SelectionCase& c) { return percent_of(c.inferior_right, c.found.inferior.size()); }},
    {"under_line_at_truth_percent",
     "under the line at true poses",
     "%",
     1,
     {},
     [](const SelectionCase& c) {
       return percent_of(c.under_line_at_truth, static_cast<std::size_t>(c.judged()));
     }},
    {"chosen", "chosen, I", "", 0, 100.0,
     [](const SelectionCase& c) { return static_cast<double>(c.choice.chosen.size()); }},
    {"spacing",
     "grid spacing",
     "frames",
     1,
     {},
     [](const SelectionCase& c) { return c.choice.spacing; }},
};

std::vector<double> selection_values(const std::vector<SelectionCase>& cases,
                                     const std::string& test, const SelectionColumn& column) {
  std::vector<double> values;
  for (const SelectionCase& c : cases) {
    if (c.test != test) continue;
    const double value = column.of(c);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

}  // namespace

std::vector<std::string> selection_protocol() {
  return {
      "Tried: random pairs of frames 2 to slam.loop.pairs.max_gap apart. Overlapping: of them, "
      "those whose view cones share more than slam.loop.pairs.overlap_limit. Promising: of these, "
      "those with e < 0.3 m + λ · 0.5 m (Eq. 27).",
      "nearest: λ and e where the chain lays the frames. icp: where a trimmed ICP from there ends. "
      "The text describes the first; Figure 9 speaks of ICP attempts.",
      fmt::format("Right: the motion that was judged is within {} m and {}° of the true one.",
                  kRightPair_m, kRightPair_deg),
      "Under the line at true poses: what Eq. 27 says of the same pairs where they truly lie, the "
      "floor of the scatter.",
      "The paper inspected 1,870,000 pairs for 3,500 promising ones (0.2 %; 2,800 in the caption "
      "of "
      "Figure 10). The share depends on how often the road returns to itself within the largest "
      "gap, so it is an outcome, not a target.",
  };
}

ReportTable selection_table(const std::vector<SelectionCase>& cases) {
  ReportTable table;
  table.title = "Selection of pairs";
  table.protocol = "means over the trials";
  table.headers = {{"test"}};
  for (const SelectionColumn& column : kSelectionColumns) {
    table.headers.push_back({column.title, column.unit});
  }
  for (const std::string test : {"nearest", "icp"}) {
    std::vector<ReportCell> row = {{test}};
    for (const SelectionColumn& column : kSelectionColumns) {
      const auto value = mean(selection_values(cases, test, column));
      row.push_back(compared(value.value_or(std::nan("")), column.paper, column.decimals));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

SummaryTable selection_json(const std::vector<SelectionCase>& cases) {
  SummaryTable table;
  for (const std::string test : {"nearest", "icp"}) {
    Json row, paper;
    row["test"] = test;
    for (const SelectionColumn& column : kSelectionColumns) {
      const auto values = selection_values(cases, test, column);
      const auto value = mean(values);
      row[column.name] = value ? Json(*value) : Json();
      if (const auto interval = bootstrap_mean(values)) {
        row[std::string(column.name) + "_interval"] = {interval->low, interval->high};
      }
      if (column.paper) paper[column.name] = *column.paper;
    }
    row["paper"] = paper;
    if (table.columns.empty()) {
      for (const auto& item : row.items()) table.columns.push_back(item.key());
    }
    table.rows.push_back(std::move(row));
  }
  table.protocol = fmt::format("{}", fmt::join(selection_protocol(), " "));
  return table;
}

Table selection_trial_table(const std::vector<SelectionCase>& cases) {
  Table table({
      {"trial", "", "trial (seed)", std::vector<std::int64_t>{}},
      {"test", "", "of pairs", std::vector<std::string>{}},
      {"key_frames", "", "of the drive", std::vector<std::int64_t>{}},
      {"pairs_tried", "", "random pairs", std::vector<std::int64_t>{}},
      {"promising", "", "in I2", std::vector<std::int64_t>{}},
      {"inferior", "", "overlapping, above the line of Eq. 27", std::vector<std::int64_t>{}},
      {"promising_right", "", "whose motion is right", std::vector<std::int64_t>{}},
      {"inferior_right", "", "whose motion is right", std::vector<std::int64_t>{}},
      {"under_line_at_truth", "", "of all judged pairs", std::vector<std::int64_t>{}},
      {"chosen", "", "in I", std::vector<std::int64_t>{}},
      {"spacing", "", "of the grid, frames", std::vector<double>{}},
  });
  for (const SelectionCase& c : cases) {
    table.add_row(c.trial, c.test, c.frames, c.found.tried, c.found.promising.size(),
                  c.found.inferior.size(), c.promising_right, c.inferior_right,
                  c.under_line_at_truth, c.choice.chosen.size(), c.choice.spacing);
  }
  return table;
}

Table selection_pair_table(const std::vector<SelectionCase>& cases) {
  Table table({
      {"trial", "", "row in /trials", std::vector<std::int64_t>{}},
      {"j", "", "earlier frame", std::vector<std::int64_t>{}},
      {"i", "", "later frame", std::vector<std::int64_t>{}},
      {"overlap", "", "λ of the view cones", std::vector<double>{}},
      {"error_m", "m", "e of the match", std::vector<double>{}},
      {"promising", "", "1 below the line of Eq. 27", std::vector<std::int64_t>{}},
  });
  for (std::size_t row = 0; row < cases.size(); ++row) {
    for (const auto* pairs : {&cases[row].found.promising, &cases[row].found.inferior}) {
      const bool promising = pairs == &cases[row].found.promising;
      for (const FramePair& pair : *pairs) {
        table.add_row(row, std::int64_t{pair.j}, std::int64_t{pair.i}, pair.overlap, pair.error_m,
                      promising);
      }
    }
  }
  return table;
}

}  // namespace honka::eval
