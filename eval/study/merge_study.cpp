#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "algo/types/user_error.h"
#include "eval/study/journal.h"
#include "eval/study/point_ends.h"
#include "eval/study/run_study.h"

namespace honka::eval {
namespace {

std::string shard_command(const StudyFolder& folder, const Study& study, const Shard& shard) {
  return fmt::format("{} --shard {}/{} --out {}", study_command(study), shard.index, shard.count,
                     folder.path().string());
}

/// Every shard of the division, each with its finished file and no journal beside it.
std::vector<Shard> all_shards(const StudyFolder& folder, const Study& study) {
  const std::vector<Shard> there = folder.shards();
  if (there.empty()) {
    throw UserError(fmt::format("{}: holds no shards yet; run {}", folder.path().string(),
                                shard_command(folder, study, {0, 1})));
  }
  std::vector<Shard> shards;
  for (std::int64_t index = 0; index < there.front().count; ++index) {
    const Shard shard{index, there.front().count};
    const bool begun = std::filesystem::exists(folder.journal(shard));
    if (!begun && std::filesystem::exists(folder.finished(shard))) {
      shards.push_back(shard);
      continue;
    }
    throw UserError(fmt::format("{}: shard {}/{} {}; run {}", folder.path().string(), shard.index,
                                shard.count, begun ? "is not finished" : "is missing",
                                shard_command(folder, study, shard)));
  }
  return shards;
}

Table gathered(const Table& rows, const std::vector<std::size_t>& order) {
  Table table;
  for (const Column& column : rows.columns()) {
    Column sorted = column;
    std::visit(
        [&](auto& values) {
          auto taken = values;
          taken.clear();
          taken.reserve(order.size());
          for (const std::size_t row : order) taken.push_back(std::move(values[row]));
          values = std::move(taken);
        },
        sorted.values);
    table.add_column(std::move(sorted));
  }
  return table;
}

/// Rows in the order of (point, trial, method); within a trial they stand in that of the methods.
std::vector<std::size_t> sorted_rows(const Table& rows) {
  const auto& point = rows.ints("point");
  const auto& trial = rows.ints("trial");
  std::vector<std::size_t> order(rows.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(point[a], trial[a]) < std::pair(point[b], trial[b]);
  });
  return order;
}

/// Where each point ends, from the rows of all its trials.
PointEnds ends_of(const Study& study, const Table& rows) {
  PointEnds ends(study);
  if (study.base.scenario.study.stop_half_width <= 0.0) return ends;
  const auto& rate = rows.doubles(study.kind->measures.front().name);
  const std::size_t methods = study.methods.size();
  std::vector<std::uint8_t> holds(methods);
  for (std::size_t row = 0; row + methods <= rows.rows(); row += methods) {
    for (std::size_t m = 0; m < methods; ++m) holds[m] = rate[row + m] == 1.0 ? 1 : 0;
    ends.add({rows.ints("point")[row], rows.ints("trial")[row]}, holds);
  }
  return ends;
}

[[noreturn]] void wrong_trial(const StudyFolder& folder, const Study& study, TrialId id,
                              const std::string& what) {
  throw UserError(fmt::format("{}: trial {} of point {} ({}) {}; run {}", folder.path().string(),
                              id.trial, id.point, point_name(study, id.point), what,
                              shard_command(folder, study, {0, 1})));
}

/// The rows that count, after a look that each trial is there exactly once.
Table complete_rows(const StudyFolder& folder, const Study& study, const Table& rows) {
  const PointEnds ends = ends_of(study, rows);
  const std::size_t methods = study.methods.size();
  const auto& point = rows.ints("point");
  const auto& trial = rows.ints("trial");
  std::vector<std::size_t> counting;
  std::size_t row = 0;
  for (std::int64_t p = 0; p < static_cast<std::int64_t>(study.points.size()); ++p) {
    for (std::int64_t t = 0; t < ends.end(p); ++t, row += methods) {
      const bool there = row + methods <= rows.rows() && point[row] == p && trial[row] == t;
      if (!there) {
        const bool twice = row < rows.rows() && std::pair(point[row], trial[row]) < std::pair(p, t);
        wrong_trial(folder, study, twice ? TrialId{point[row], trial[row]} : TrialId{p, t},
                    twice ? "is there twice: shards overlap" : "is missing");
      }
      for (std::size_t m = 0; m < methods; ++m) counting.push_back(row + m);
    }
    while (row < rows.rows() && point[row] == p && trial[row] >= ends.end(p)) ++row;
  }
  return gathered(rows, counting);
}

}  // namespace

StudyOutcome merge_study(const StudyFolder& folder, const Study& study,
                         const std::string& command) {
  const Context context(1, study.base.scenario.seed);
  Table rows = study_table(study, {});
  for (const Shard& shard : all_shards(folder, study)) {
    rows.append_rows(read_shard(folder, study, shard));
  }
  const Table sorted = gathered(rows, sorted_rows(rows));
  return write_study_results(study, complete_rows(folder, study, sorted), context, folder.path(),
                             command);
}

}  // namespace honka::eval
