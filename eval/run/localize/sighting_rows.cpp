#include "eval/run/localize/sighting_rows.h"

#include <cmath>
#include <limits>

namespace honka::eval {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Column sighting_integers(std::string name, std::string long_name) {
  return {std::move(name), "", std::move(long_name), std::vector<std::int64_t>{}};
}

Column sighting_words(std::string name, std::string long_name) {
  return {std::move(name), "", std::move(long_name), std::vector<std::string>{}};
}

Column sighting_numbers(std::string name, std::string unit, std::string long_name,
                        bool in_digest = true) {
  return {std::move(name), std::move(unit), std::move(long_name), std::vector<double>{}, in_digest};
}

/// Root of the variances of x and y together; NaN where a matcher states none.
double stated_m(const LocateResult& result) {
  if (!result.covariance) return kNoNumber;
  return std::sqrt(result.covariance->topLeftCorner<2, 2>().trace());
}

double bytes_or_nan(const std::optional<std::int64_t>& bytes) {
  return bytes ? static_cast<double>(*bytes) : kNoNumber;
}

}  // namespace

Table sighting_map_table() {
  return Table(
      {sighting_words("case", "kind of map and lists"), sighting_words("method", "matcher"),
       sighting_integers("trial", "forest"), sighting_integers("stems_in_map", "stems in the map"),
       sighting_integers("queries", "stem lists asked"),
       sighting_numbers("build_ms", "ms", "making graph or index, one thread", false),
       sighting_numbers("index_bytes", "B", "the index as a file; NaN where there is none"),
       sighting_numbers("memory_bytes", "B", "held at most while it was made", false)});
}

Table sighting_table() {
  return Table({
      sighting_words("case", "kind of map and lists"),
      sighting_words("method", "matcher"),
      sighting_integers("trial", "forest"),
      sighting_integers("query", "number of the list within the case"),
      sighting_integers("stems_in_map", "stems in the map"),
      sighting_integers("stems", "stems in the list"),
      sighting_integers("true_stems", "of these, trees that are in the map"),
      sighting_integers("matches", "pairs or stars that the matcher found"),
      sighting_integers("agreeing", "of these, agreeing with the answer"),
      sighting_integers("inliers", "listed stems with a partner under the answer"),
      sighting_numbers("margin", "", "the matcher's own, over the acceptance"),
      sighting_words("verdict", "accepted | ambiguous | not_in_map | too_few_stems"),
      sighting_integers("accepted", "1 when the answer was accepted"),
      sighting_integers("success", "1 when accepted and right"),
      sighting_numbers("x_m", "m", "answer in the map; NaN when refused"),
      sighting_numbers("y_m", "m", "answer in the map; NaN when refused"),
      sighting_numbers("yaw_rad", "rad", "answer in the map; NaN when refused"),
      sighting_numbers("true_x_m", "m", "truth; NaN for a list from elsewhere"),
      sighting_numbers("true_y_m", "m", "truth; NaN for a list from elsewhere"),
      sighting_numbers("true_yaw_rad", "rad", "truth; NaN for a list from elsewhere"),
      sighting_numbers("translation_error_m", "m", "to truth; NaN when refused"),
      sighting_numbers("rotation_error_rad", "rad", "to truth; NaN when refused"),
      sighting_numbers("bound_m", "m", "Cramér-Rao bound of the position; NaN where there is none"),
      sighting_numbers("bound_rad", "rad", "Cramér-Rao bound of the yaw; NaN where there is none"),
      sighting_numbers("stated_m", "m",
                       "s.d. of the position as the matcher states it; NaN where it does not"),
      sighting_numbers("match_ms", "ms", "matching alone, one thread", false),
  });
}

void append(Table& table, const SightingMapRow& row) {
  table.add_row(row.name, row.method, row.trial, row.stems_in_map, row.queries, row.build_ms,
                bytes_or_nan(row.index_bytes), bytes_or_nan(row.memory_bytes));
}

void append(Table& table, const SightingRow& row) {
  const LocateResult& r = row.result;
  const Pose2& answer = r.T_map_local;
  const auto if_accepted = [&](double value) { return r.accepted() ? value : kNoNumber; };
  const auto if_known = [&](double value) { return row.T_map_sensor ? value : kNoNumber; };
  const auto if_both = [&](double value) { return if_known(if_accepted(value)); };
  const Pose2 truth = row.T_map_sensor.value_or(Pose2{});
  table.add_row(
      row.name, row.method, row.trial, row.query, row.stems_in_map, row.stems, row.true_stems,
      r.matches, r.agreeing, r.inliers, r.margin, verdict_name(r.verdict), r.accepted(),
      row.success, if_accepted(answer.translation_m.x()), if_accepted(answer.translation_m.y()),
      if_accepted(answer.yaw_rad), if_known(truth.translation_m.x()),
      if_known(truth.translation_m.y()), if_known(truth.yaw_rad), if_both(row.error.translation_m),
      if_both(row.error.rotation_rad), row.bound ? row.bound->translation_m : kNoNumber,
      row.bound ? row.bound->rotation_rad : kNoNumber, if_accepted(stated_m(r)), row.match_ms);
}

}  // namespace honka::eval
