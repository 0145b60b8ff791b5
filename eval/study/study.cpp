#include "eval/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/config/value.h"

namespace honka::eval {
namespace {

/// Of what the digits of a trial depend on, and which columns it has.
std::string identity_of(const Study& study) {
  std::string text = study.kind->experiment + "\n";
  for (const Measure& measure : study.kind->measures) text += measure.name + " ";
  for (const std::string& method : study.methods) text += "\n" + method;
  for (const StudyAxis& axis : study.axes()) text += "\n" + axis.key;
  for (const StudyPoint& point : study.points) text += "\n" + point.resolved.hash;
  return sha256_hex(text);
}

void check_methods(const Study& study) {
  for (const StudyPoint& point : study.points) {
    if (study.kind->methods(point.resolved.scenario) == study.methods &&
        point.resolved.scenario.experiment == study.kind->experiment) {
      continue;
    }
    throw UserError(
        fmt::format("{}: experiment and methods are the same at every point of a study; each trial "
                    "asks all of them, so take them out of [study.vary]",
                    study.base.file.string()));
  }
}

/// A text axis has a text column; all numbers are doubles, so that 1 and 1.5 make one column.
Column axis_column(const StudyAxis& axis) {
  const bool text = std::holds_alternative<std::string>(axis.values.front());
  Column column{axis.key, "", "value of " + axis.key, {}};
  column.values = text ? ColumnValues(std::vector<std::string>()) : std::vector<double>();
  return column;
}

void add_axis_cell(Column& column, const Value& value) {
  if (auto* texts = std::get_if<std::vector<std::string>>(&column.values)) {
    texts->push_back(std::get<std::string>(value));
    return;
  }
  auto& numbers = std::get<std::vector<double>>(column.values);
  if (const auto* number = std::get_if<double>(&value)) numbers.push_back(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    numbers.push_back(static_cast<double>(*integer));
  }
  if (const auto* yes = std::get_if<bool>(&value)) numbers.push_back(*yes ? 1.0 : 0.0);
}

/// The columns of study_table(), by what fills them.
struct StudyColumns {
  std::vector<std::int64_t> point, trial;
  std::vector<std::string> method, status, cause;
  std::vector<Column> axes;
  std::vector<std::vector<double>> measures;
  std::vector<double> wall_s, cpu_s, resident_mb;
};

void add_rows(StudyColumns& columns, const Study& study, const TrialRecord& record) {
  const std::vector<Value>& at = study.points.at(static_cast<std::size_t>(record.id.point)).values;
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    columns.point.push_back(record.id.point);
    columns.trial.push_back(record.id.trial);
    columns.method.push_back(study.methods[m]);
    columns.status.emplace_back(name_of(record.status));
    columns.cause.push_back(record.cause);
    for (std::size_t k = 0; k < at.size(); ++k) add_axis_cell(columns.axes[k], at[k]);
    const bool done = record.status == TrialStatus::kDone;
    for (std::size_t k = 0; k < columns.measures.size(); ++k) {
      columns.measures[k].push_back(done ? record.results.at(m).values.at(k)
                                         : std::numeric_limits<double>::quiet_NaN());
    }
    columns.wall_s.push_back(record.wall_s);
    columns.cpu_s.push_back(record.cpu_s);
    columns.resident_mb.push_back(static_cast<double>(record.resident_bytes) / kBytesPerMegabyte);
  }
}

Table table_of(StudyColumns columns, const Study& study) {
  std::vector<Column> all = {
      {"point", "", "number of the point", std::move(columns.point)},
      {"trial", "", "number of the trial at the point", std::move(columns.trial)},
      {"method", "", "what was asked", std::move(columns.method)},
  };
  for (Column& axis : columns.axes) all.push_back(std::move(axis));
  all.push_back({"status", "", "how the trial ended", std::move(columns.status)});
  // A signal's or an allocator's words differ from machine to machine.
  all.push_back({"cause", "", "why it failed", std::move(columns.cause), false});
  for (std::size_t k = 0; k < columns.measures.size(); ++k) {
    const Measure& measure = study.kind->measures[k];
    all.push_back({measure.name, measure.unit, measure.long_name, std::move(columns.measures[k]),
                   measure.kind != MeasureKind::kTime});
  }
  all.push_back({"wall_s", "s", "time of the trial, every method, its world if it had to be made",
                 std::move(columns.wall_s), false});
  all.push_back({"cpu_s", "s", "processor time of the same", std::move(columns.cpu_s), false});
  all.push_back({"resident_mb", "MB", "memory of the worker when the trial ended",
                 std::move(columns.resident_mb), false});
  return Table(std::move(all));
}

std::string with_overrides(const std::string& verb, const Study& study) {
  std::string command = fmt::format("{} {}", verb, study.base.file.string());
  for (const std::string& text : study.overrides) command += fmt::format(" -s '{}'", text);
  return command;
}

}  // namespace

Study load_study(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                 std::optional<std::int64_t> trials) {
  Study study;
  study.base = load_scenario(file, overrides);
  study.overrides = overrides;
  if (!study.base.scenario.study.asked_for()) {
    throw UserError(fmt::format(
        "{}: nothing varies, so this is no study; add [study.vary] with a key and its values, "
        "sighting.noise_m = [0.1, 0.2], or give it to honka run",
        file.string()));
  }
  study.points = load_study_points(file, overrides);
  study.kind = &find_study_kind(study.points.front().resolved);
  study.methods = study.kind->methods(study.points.front().resolved.scenario);
  study.trials = trials.value_or(study.base.scenario.study.trials);
  check_methods(study);
  study.identity = identity_of(study);
  return study;
}

std::string point_name(const Study& study, std::int64_t point) {
  const std::vector<Value>& at = study.points.at(static_cast<std::size_t>(point)).values;
  std::string name;
  for (std::size_t k = 0; k < at.size(); ++k) {
    name += fmt::format("{}{} = {}", k == 0 ? "" : ", ", study.axes()[k].key, format_value(at[k]));
  }
  return name;
}

std::string study_command(const Study& study) {
  return with_overrides("honka study", study) + fmt::format(" --trials {}", study.trials);
}

std::string replay_command(const Study& study, TrialId id) {
  std::string command = with_overrides("honka run", study);
  const std::vector<Value>& at = study.points.at(static_cast<std::size_t>(id.point)).values;
  for (std::size_t k = 0; k < at.size(); ++k) {
    command += fmt::format(" -s '{}={}'", study.axes()[k].key, format_value(at[k]));
  }
  return command + fmt::format(" --trial {}", id.trial);
}

Table study_table(const Study& study, std::vector<TrialRecord> records) {
  std::sort(records.begin(), records.end(),
            [](const TrialRecord& a, const TrialRecord& b) { return a.id < b.id; });
  StudyColumns columns;
  columns.measures.resize(study.kind->measures.size());
  for (const StudyAxis& axis : study.axes()) columns.axes.push_back(axis_column(axis));
  for (const TrialRecord& record : records) add_rows(columns, study, record);
  return table_of(std::move(columns), study);
}

}  // namespace honka::eval
