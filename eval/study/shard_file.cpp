#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "algo/types/user_error.h"
#include "eval/study/study_folder.h"

namespace honka::eval {
namespace {

std::map<std::string, std::string> shard_context(const Study& study, const Shard& shard) {
  return {{"identity", study.identity},
          {"version", honka_version()},
          {"shard", fmt::format("{}/{}", shard.index, shard.count)}};
}

TrialStatus status_named(const std::string& name) {
  constexpr std::array kAll = {TrialStatus::kDone, TrialStatus::kThrew, TrialStatus::kTimedOut,
                               TrialStatus::kOutOfMemory, TrialStatus::kCrashed};
  const auto* found = std::find_if(kAll.begin(), kAll.end(),
                                   [&](TrialStatus status) { return name_of(status) == name; });
  return found == kAll.end() ? TrialStatus::kCrashed : *found;
}

}  // namespace

void write_shard(const StudyFolder& folder, const Study& study, const Shard& shard,
                 std::vector<TrialRecord> records) {
  write_trials_h5(folder.finished(shard), shard_context(study, shard),
                  study_table(study, std::move(records)), Table());
}

Table read_shard(const StudyFolder& folder, const Study& study, const Shard& shard) {
  const std::filesystem::path file = folder.finished(shard);
  const auto context = read_context_h5(file);
  for (const auto& [key, value] : shard_context(study, shard)) {
    const auto there = context.find(key);
    if (there != context.end() && there->second == value) continue;
    throw UserError(fmt::format(
        "{}: its {} is {}, that of the study {}; move the file away and run this shard again",
        file.string(), key, there == context.end() ? "missing" : there->second, value));
  }
  Table rows = read_table(file, "trials");
  const Table schema = study_table(study, {});
  bool same = rows.columns().size() == schema.columns().size();
  for (std::size_t k = 0; same && k < schema.columns().size(); ++k) {
    same = rows.columns()[k].name == schema.columns()[k].name &&
           rows.columns()[k].values.index() == schema.columns()[k].values.index();
  }
  if (same) return rows;
  throw UserError(file.string() +
                  ": other columns than the study's; move the file away and run this shard again");
}

std::vector<TrialRecord> records_of(const Study& study, const Table& rows) {
  const std::size_t methods = study.methods.size();
  std::vector<TrialRecord> records;
  for (std::size_t row = 0; row + methods <= rows.rows(); row += methods) {
    TrialRecord& record = records.emplace_back();
    record.id = {rows.ints("point")[row], rows.ints("trial")[row]};
    record.status = status_named(rows.strings("status")[row]);
    record.cause = rows.strings("cause")[row];
    record.wall_s = rows.doubles("wall_s")[row];
    record.cpu_s = rows.doubles("cpu_s")[row];
    record.resident_bytes =
        static_cast<std::int64_t>(rows.doubles("resident_mb")[row] * kBytesPerMegabyte + 0.5);
    if (record.status != TrialStatus::kDone) continue;
    for (std::size_t m = 0; m < methods; ++m) {
      MethodResult& result = record.results.emplace_back();
      result.method = rows.strings("method")[row + m];
      for (const Measure& measure : study.kind->measures) {
        result.values.push_back(rows.doubles(measure.name)[row + m]);
      }
    }
  }
  return records;
}

}  // namespace honka::eval
