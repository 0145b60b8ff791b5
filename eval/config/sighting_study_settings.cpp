#include "eval/config/sighting_study_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace {

void describe_lists(SettingsVisitor& v, SightingCaseLists& s) {
  v.field({"stems_in_map", "", "sighting.map.stems of each case", "choice"}, s.stems_in_map,
          {1, 5e6});
  v.field({"most_stems", "", "sighting.most_stems of each case", "choice"}, s.most_stems,
          {0, 100000});
  v.field({"noise_m", "m", "sighting.noise_m of each case", "choice"}, s.noise_m, {0, 10});
  v.field({"missed_share", "", "sighting.missed_share of each case", "choice"}, s.missed_share,
          {0, 1});
  v.field({"false_share", "", "sighting.false_share of each case", "choice"}, s.false_share,
          {0, 0.95});
  v.field({"felled_share", "", "sighting.map.felled_share of each case", "choice"}, s.felled_share,
          {0, 1});
  v.field({"queries", "", "sighting.queries of each case", "choice"}, s.queries, {1, 1e7});
  v.field({"li2020_queries", "", "sighting.li2020_queries of each case", "choice"},
          s.li2020_queries, {0, 1e7});
}

/// Number of cases that the lists give.
std::size_t count_of(const SightingCaseLists& lists) {
  std::size_t count = 0;
  const auto add = [&](const char* key, std::size_t size) {
    if (size == 0) return;
    if (count != 0 && size != count) {
      throw UserError(fmt::format(
          "sighting.cases.{}: {} entries where another list has {}; give each case one, or leave "
          "the list out",
          key, size, count));
    }
    count = size;
  };
  add("stems_in_map", lists.stems_in_map.size());
  add("most_stems", lists.most_stems.size());
  add("noise_m", lists.noise_m.size());
  add("missed_share", lists.missed_share.size());
  add("false_share", lists.false_share.size());
  add("felled_share", lists.felled_share.size());
  add("queries", lists.queries.size());
  add("li2020_queries", lists.li2020_queries.size());
  return count;
}

template <class Number>
void take(const std::vector<Number>& list, std::size_t place, Number& value) {
  if (!list.empty()) value = list[place];
}

std::string name_of(const SightingCaseLists& lists, const SightingCase& one) {
  std::string name;
  const auto add = [&](const std::string& part) { name += (name.empty() ? "" : ", ") + part; };
  if (!lists.stems_in_map.empty()) add(fmt::format("{} stems in the map", one.map.stems));
  if (!lists.noise_m.empty()) add(fmt::format("noise {:g} m", one.detector.noise_m));
  const auto percent = [&](const std::vector<double>& list, double share, const char* what) {
    if (!list.empty() && share > 0.0) add(fmt::format("{:g} % {}", 100.0 * share, what));
  };
  percent(lists.missed_share, one.detector.missed_share, "missed");
  percent(lists.false_share, one.detector.false_share, "false");
  if (one.detector.most_stems > 0 && !lists.most_stems.empty()) {
    add(fmt::format("{} stems", one.detector.most_stems));
  }
  percent(lists.felled_share, one.map.felled_share, "felled");
  if (!name.empty()) return name;
  return count_of(lists) == 0 ? "all" : "every tree in view";
}

}  // namespace

void describe(SettingsVisitor& v, SightingStudySettings& s) {
  describe(v, s.detector);
  v.field({"border_m", "m", "the sensor stands at least so far inside the forest",
           "choice: the range, so that no view ends at the forest's edge"},
          s.border_m, {0, 10000});
  v.field(
      {"elsewhere", "", "lists are of another forest of the same kind, not of the map's", "choice"},
      s.elsewhere);
  v.field({"queries", "", "stem lists a case, spread over the trials", "choice"}, s.queries,
          {1, 1e7});
  v.field({"li2020_queries", "", "of these, asked of li2020; 0: none",
           "choice: its time grows with the map"},
          s.li2020_queries, {0, 1e7});
  v.group("map", [&] { describe(v, s.map); });
  v.group("cases", [&] { describe_lists(v, s.cases); });
}

std::vector<SightingCase> sighting_cases(const SightingStudySettings& settings) {
  const SightingCaseLists& lists = settings.cases;
  std::vector<SightingCase> cases;
  for (std::size_t k = 0; k < std::max<std::size_t>(count_of(lists), 1); ++k) {
    SightingCase one{"", settings.detector, settings.map, settings.queries,
                     settings.li2020_queries};
    take(lists.stems_in_map, k, one.map.stems);
    take(lists.felled_share, k, one.map.felled_share);
    take(lists.most_stems, k, one.detector.most_stems);
    take(lists.noise_m, k, one.detector.noise_m);
    take(lists.missed_share, k, one.detector.missed_share);
    take(lists.false_share, k, one.detector.false_share);
    take(lists.queries, k, one.queries);
    take(lists.li2020_queries, k, one.li2020_queries);
    one.name = name_of(lists, one);
    cases.push_back(std::move(one));
  }
  return cases;
}

void describe(SettingsVisitor& v, StemPairSettings& s) {
  const char* found = "brute-force search over turn and shift, RMSE 0.18 to 0.24 m";
  v.field({"folder", "", "holds NAME_field.csv and NAME_tls.csv; not part of the project",
           "FORTLS, Rioja.data (GPL-3)"},
          s.folder, {});
  v.field({"names", "", "of the plots, with commas between", "FORTLS, Rioja.data"}, s.names, {});
  v.field({"yaw_deg", "deg", "turn of each plot's scan into its field map", found}, s.yaw_deg,
          {-180, 180});
  v.field({"x_m", "m", "place of each plot's scanner in its field map", found}, s.x_m, {-1e7, 1e7});
  v.field({"y_m", "m", "place of each plot's scanner in its field map", found}, s.y_m, {-1e7, 1e7});
  v.field({"within_m", "m", "an answer so near to the brute-force one is right", "choice"},
          s.within_m, {0.001, 100});
  v.field({"within_deg", "deg", "and within", "choice"}, s.within_deg, {0.001, 180});
}

}  // namespace honka::eval
