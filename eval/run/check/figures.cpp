#include "eval/run/check/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "eval/io/text_table.h"
#include "eval/run/check/tolerance.h"

namespace honka::eval {
namespace {

/// A cell of a row with the way to it: "translation_error_m.mean".
struct Leaf {
  std::string name;
  Json value;
};

bool is_interval(std::string_view name) { return name.find("interval") != std::string_view::npos; }

void collect_leaves(const std::string& name, const Json& value, std::vector<Leaf>& leaves) {
  if (is_cost(name) || name == "paper") return;
  const std::string prefix = name.empty() ? "" : name + ".";
  if (is_interval(name) || value.is_primitive()) {
    leaves.push_back({name, value});
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items()) collect_leaves(prefix + key, member, leaves);
  } else {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect_leaves(prefix + std::to_string(i), value[i], leaves);
    }
  }
}

std::vector<Leaf> leaves_of(const Json& row) {
  std::vector<Leaf> leaves;
  collect_leaves("", row, leaves);
  return leaves;
}

/// The text of a cell, without the mark that separates the cells of a row.
std::string cell_text(const Json& value) {
  std::string text = value.is_string()         ? value.get<std::string>()
                     : value.is_number_float() ? exact_text(value.get<double>())
                                               : value.dump();
  std::replace(text.begin(), text.end(), ';', ',');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string label_of(const Json& row, const std::vector<std::string>& keys) {
  std::string label;
  for (const std::string& key : keys) {
    if (!row.contains(key)) continue;
    label += (label.empty() ? "" : "; ") + key + "=" + cell_text(row.at(key));
  }
  return label;
}

std::size_t labels_of(const std::vector<Json>& rows, const std::vector<std::string>& keys) {
  std::set<std::string> labels;
  for (const Json& row : rows) labels.insert(label_of(row, keys));
  return labels.size();
}

/// 0: words, 1: whole numbers, 2: other numbers; 3: no part of a name.
int rank_of_column(const std::vector<Json>& rows, const std::string& column) {
  int rank = 0;
  for (const Json& row : rows) {
    if (!row.contains(column) || is_cost(column) || is_interval(column)) return 3;
    const Json& value = row.at(column);
    if (!value.is_primitive() || value.is_null()) return 3;
    if (value.is_number_integer()) rank = std::max(rank, 1);
    if (value.is_number_float()) rank = std::max(rank, 2);
  }
  return rank;
}

/// Columns that tell the rows apart, in the order of the table.
std::vector<std::string> naming_columns(const SummaryTable& table) {
  std::vector<std::string> keys;
  const auto in_order = [&](const std::string& a, const std::string& b) {
    const auto& columns = table.columns;
    return std::find(columns.begin(), columns.end(), a) <
           std::find(columns.begin(), columns.end(), b);
  };
  std::size_t known = 0;
  for (int rank = 0; rank < 3; ++rank) {
    for (const std::string& column : table.columns) {
      if (known == table.rows.size() || rank_of_column(table.rows, column) != rank) continue;
      auto more = keys;
      more.insert(std::upper_bound(more.begin(), more.end(), column, in_order), column);
      const std::size_t labels = labels_of(table.rows, more);
      if (labels == known) continue;
      keys = more;
      known = labels;
    }
  }
  return keys;
}

std::optional<double> number_of(const Json& row, const std::string& column) {
  if (!row.contains(column) || !row.at(column).is_number()) return std::nullopt;
  return row.at(column).get<double>();
}

/// Over how many trials the figures of a row are taken.
std::optional<double> trials_of(const Json& row) {
  static constexpr std::array kColumns = {"windows", "queries", "pairs", "trials", "of", "n"};
  for (const char* column : kColumns) {
    if (const auto n = number_of(row, column)) return n;
  }
  return std::nullopt;
}

std::optional<std::array<double, 2>> interval_in(const Json& value) {
  if (!value.is_array() || value.size() != 2) return std::nullopt;
  if (!value[0].is_number() || !value[1].is_number()) return std::nullopt;
  return {{value[0].get<double>(), value[1].get<double>()}};
}

/// "blur_interval" is that of blur, "success_interval" that of success_rate, "x.interval" of
/// x.value.
bool is_interval_of(const std::string& interval, const std::string& name) {
  for (const std::string end : {"_interval", ".interval"}) {
    if (!interval.ends_with(end)) continue;
    const std::string base = interval.substr(0, interval.size() - end.size());
    for (const std::string more : {"", "_rate", ".value", ".mean", ".rate"}) {
      if (name == base + more) return true;
    }
  }
  return false;
}

FigureSpread spread_of(const std::vector<Leaf>& leaves, const Json& row, const Leaf& leaf) {
  FigureSpread spread;
  spread.is_count = leaf.value.is_number_integer();
  spread.trials = trials_of(row);
  spread.success_rate = number_of(row, "success_rate");
  for (const Leaf& other : leaves) {
    // "wrong_interval" is that of the rate beside the count "wrong".
    if (!spread.is_count && is_interval_of(other.name, leaf.name)) {
      spread.interval = interval_in(other.value);
    }
    const bool of_mean = leaf.name.ends_with(".mean") &&
                         other.name == leaf.name.substr(0, leaf.name.size() - 4) + "std";
    if (of_mean && other.value.is_number()) spread.standard_deviation = other.value.get<double>();
  }
  return spread;
}

CheckFigure figure_of(const Leaf& leaf, const FigureSpread& spread) {
  CheckFigure figure;
  figure.column = leaf.name;
  if (leaf.value.is_number() && std::isfinite(leaf.value.get<double>())) {
    figure.number = leaf.value.get<double>();
    figure.tolerance = tolerance_of(leaf.name, *figure.number, spread);
  } else {
    figure.word = leaf.value.is_number() ? "null" : cell_text(leaf.value);
  }
  return figure;
}

void append_table(const std::string& name, const SummaryTable& table,
                  std::vector<CheckFigure>& figures) {
  const auto keys = naming_columns(table);
  std::map<std::string, int> same;
  for (const Json& row : table.rows) {
    if (row.contains("unit") && row.at("unit").is_string() &&
        is_cost(fmt::format("_{}", row.at("unit").get<std::string>()))) {
      continue;
    }
    std::string label = label_of(row, keys);
    if (const int again = same[label]++; again > 0 || label.empty()) {
      label += (label.empty() ? "row=" : "; row=") + std::to_string(again + 1);
    }
    const auto leaves = leaves_of(row);
    for (const Leaf& leaf : leaves) {
      if (is_interval(leaf.name) || std::count(keys.begin(), keys.end(), leaf.name) > 0) continue;
      figures.push_back(figure_of(leaf, spread_of(leaves, row, leaf)));
      figures.back().table = name;
      figures.back().row = label;
    }
  }
}

CheckFigure figure_of_metric(const std::string& name, const Metric& metric) {
  FigureSpread spread;
  spread.interval = metric.interval;
  if (metric.of > 0) spread.trials = static_cast<double>(metric.of);
  CheckFigure figure{"metrics", name, "value", {}, "null", 0.0};
  if (std::isfinite(metric.value)) {
    figure.number = metric.value;
    figure.word.clear();
    figure.tolerance = tolerance_of(name, metric.value, spread);
  }
  return figure;
}

}  // namespace

std::string value_text(const CheckFigure& figure) {
  return figure.number ? exact_text(*figure.number) : figure.word;
}

bool is_cost(std::string_view name) {
  static constexpr std::array<std::string_view, 7> kParts = {
      "time", "memory", "resident", "keeps_up", "wall_s", "cpu_s", "per_second"};
  static constexpr std::array<std::string_view, 4> kEnds = {"_ms", "_mb", "_MB", "_us"};
  return std::any_of(kParts.begin(), kParts.end(),
                     [&](auto part) { return name.find(part) != std::string_view::npos; }) ||
         std::any_of(kEnds.begin(), kEnds.end(), [&](auto end) { return name.ends_with(end); });
}

std::vector<CheckFigure> figures_of(const Summary& summary) {
  std::vector<CheckFigure> figures;
  for (const auto& [name, table] : summary.tables) append_table(name, table, figures);
  for (const auto& [name, metric] : summary.metrics) {
    if (is_cost(name) || is_cost(fmt::format("_{}", metric.unit))) continue;
    figures.push_back(figure_of_metric(name, metric));
  }
  return figures;
}

}  // namespace honka::eval
