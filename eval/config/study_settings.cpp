#include "eval/config/study_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "algo/types/user_error.h"
#include "eval/config/words.h"

namespace honka::eval {
namespace {

constexpr std::string_view kVary = "study.vary.";

std::vector<Value> axis_values(const Value& value) {
  std::vector<Value> values;
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    values.assign(numbers->begin(), numbers->end());
  } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&value)) {
    values.assign(integers->begin(), integers->end());
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    for (const std::string& word : words_of(*text)) {
      values.push_back(word == "true" || word == "false" ? Value(word == "true") : Value(word));
    }
  } else {
    values.push_back(value);
  }
  return values;
}

std::vector<std::vector<Value>> grid_of(const std::vector<StudyAxis>& axes) {
  std::vector<std::vector<Value>> points = {{}};
  for (const StudyAxis& axis : axes) {
    std::vector<std::vector<Value>> longer;
    for (const auto& point : points) {
      for (const Value& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<std::vector<Value>> list_of(const std::vector<StudyAxis>& axes) {
  std::vector<std::vector<Value>> points(axes.front().values.size());
  for (const StudyAxis& axis : axes) {
    if (axis.values.size() != points.size()) {
      throw UserError(fmt::format(
          "{}: {} has {} values where {} has {}; with study.combine = \"list\" the k-th values "
          "belong together, so give each as many",
          axis.place, axis.key, axis.values.size(), axes.front().key, points.size()));
    }
    for (std::size_t k = 0; k < points.size(); ++k) points[k].push_back(axis.values[k]);
  }
  return points;
}

}  // namespace

void describe(SettingsVisitor& v, StudySettings& s) {
  v.field({"trials", "", "at each point; --trials", "choice"}, s.trials, {1, 1e7});
  v.field({"worlds", "", "forests at each point, grown once and shared: trial t is in t mod worlds",
           "choice"},
          s.worlds, {1, 1e6});
  v.field({"combine", "", "grid: every combination of what varies; list: the k-th values together",
           "choice"},
          s.combine, {"grid", "list"});
  v.field(
      {"time_limit_s", "s", "a trial that takes longer is ended and counted as failed", "choice"},
      s.time_limit_s, {0.01, 1e6});
  v.field({"memory_limit_mb", "MB", "of one worker; 0: the machine's", "choice"}, s.memory_limit_mb,
          {0, 1e7});
  v.field({"stop_half_width", "",
           "a point ends when the intervals of its first rate are narrower than this on either "
           "side; 0: never",
           "choice"},
          s.stop_half_width, {0, 0.5});
}

void take_axes(LocatedValues& values, StudySettings& settings) {
  std::vector<std::pair<std::pair<int, int>, StudyAxis>> found;
  for (auto it = values.begin(); it != values.end();) {
    if (it->first.rfind(kVary, 0) != 0) {
      ++it;
      continue;
    }
    StudyAxis axis{it->first.substr(kVary.size()), axis_values(it->second.value), it->second.place};
    if (axis.values.empty()) {
      throw UserError(fmt::format("{}: study.vary.{} is empty; give it values, [0.05, 0.1, 0.2]",
                                  axis.place, axis.key));
    }
    const auto given = values.find(axis.key);
    if (given != values.end() && given->second.line == 0) {
      settings.fixed.push_back(axis.key);
    } else {
      found.push_back({{it->second.line, it->second.column}, std::move(axis)});
    }
    it = values.erase(it);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [place, axis] : found) settings.axes.push_back(std::move(axis));
}

std::vector<std::vector<Value>> study_points(const StudySettings& settings) {
  if (settings.axes.empty()) return {{}};
  return settings.combine == "list" ? list_of(settings.axes) : grid_of(settings.axes);
}

}  // namespace honka::eval
