#include "eval/study/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "eval/study/study_tables.h"

namespace honka::eval {
namespace {

/// "sighting.noise_m (m)".
std::string label_of(const Study& study, const std::string& key) {
  for (const KeyEntry& entry : list_keys(study.base.scenario)) {
    if (entry.key == key && !entry.unit.empty()) return fmt::format("{} ({})", key, entry.unit);
  }
  return key;
}

std::size_t index_in(std::vector<std::string>& texts, const std::string& text) {
  const auto at = std::find(texts.begin(), texts.end(), text);
  if (at != texts.end()) return static_cast<std::size_t>(at - texts.begin());
  texts.push_back(text);
  return texts.size() - 1;
}

std::optional<double> as_number(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
}

bool first_axis_is_numbers(const Study& study, bool list) {
  std::vector<std::string> texts;
  for (const StudyPoint& point : study.points) {
    if (point.values.empty() || !as_number(point.values.front())) return false;
    texts.push_back(format_value(point.values.front()));
  }
  std::sort(texts.begin(), texts.end());
  const bool repeated = std::adjacent_find(texts.begin(), texts.end()) != texts.end();
  return !(list && repeated);  // two points of a list at one x would hide each other
}

/// What stands for a point on the first axis: its value there, or all of a list's.
std::string column_text(const std::vector<std::string>& texts, bool list) {
  if (texts.empty()) return "all";
  return list ? fmt::format("{}", fmt::join(texts, ", ")) : texts.front();
}

std::string slice_text(const Study& study, const std::vector<std::string>& texts) {
  std::string slice;
  for (std::size_t k = 2; k < texts.size(); ++k) {
    slice += fmt::format("{}{} = {}", k > 2 ? ", " : "", study.axes()[k].key, texts[k]);
  }
  return slice;
}

std::string axis_label(const Study& study, bool list) {
  std::vector<std::string> labels;
  for (const StudyAxis& axis : study.axes()) {
    labels.push_back(label_of(study, axis.key));
    if (!list) break;
  }
  return fmt::format("{}", fmt::join(labels, ", "));
}

}  // namespace

SweepPlan plan_sweep(const Study& study) {
  const bool list = study.base.scenario.study.combine == "list";
  const bool two = !list && study.axes().size() > 1;
  const bool numbers = first_axis_is_numbers(study, list);
  SweepPlan plan;
  plan.axis.label = axis_label(study, list);
  if (two) plan.curve_label = label_of(study, study.axes()[1].key);
  for (std::size_t point = 0; point < study.points.size(); ++point) {
    const auto texts = axis_texts(study, static_cast<std::int64_t>(point));
    SweepPlace place;
    place.column = index_in(plan.columns, column_text(texts, list));
    place.curve = index_in(plan.curves, two ? texts[1] : "");
    place.slice = index_in(plan.slices, two ? slice_text(study, texts) : "");
    place.x = numbers ? *as_number(study.points[point].values.front())
                      : static_cast<double>(place.column);
    if (numbers) plan.axis.numbers.push_back(place.x);
    plan.places.push_back(place);
  }
  if (!numbers) plan.axis.words = plan.columns;
  return plan;
}

}  // namespace honka::eval
