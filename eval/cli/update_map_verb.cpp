#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "algo/localize/map_update.h"
#include "algo/localize/matcher.h"
#include "algo/types/user_error.h"
#include "eval/cli/verbs.h"
#include "eval/io/csv.h"
#include "eval/io/safe_file.h"
#include "eval/io/stem_csv_file.h"
#include "eval/run/localize/source_map.h"

namespace honka::eval {
namespace {

using Json = nlohmann::ordered_json;
using Points = std::vector<Eigen::Vector2d>;

/// One list and what became of it.
struct UpdateView {
  LocateResult result;
  bool counted = false;
};

struct UpdatedMap {
  std::vector<UpdateView> views;
  MapUpdate update;
};

/// The matcher's complaint about the stems names their file.
std::unique_ptr<Matcher> matcher_over(const UpdateMapArguments& arguments, const Points& map_m) {
  LocalizeSettings settings;
  settings.li2020.tolerance_m2 = arguments.tolerance_m2;
  try {
    return create_matcher(arguments.method, map_m, settings);
  } catch (const UserError& error) {
    throw UserError(arguments.map.string() + ": " + error.what());
  }
}

void check_finite(const char* option, double value) {
  if (std::isfinite(value)) return;
  throw UserError(std::string(option) + ": must be a finite number");
}

/// Each list in the map as updated so far; its pose, where accepted, goes into the next update.
UpdatedMap update_by(const UpdateMapArguments& arguments, const Points& map_m,
                     const std::vector<Points>& lists) {
  MapUpdateSettings settings;
  settings.range_m = arguments.range_m;
  settings.field_of_view_deg = arguments.field_of_view_deg;
  MapUpdater updater(map_m, settings);
  UpdatedMap done;
  auto matcher = matcher_over(arguments, map_m);
  for (const Points& list : lists) {
    UpdateView view{matcher->locate(list), false};
    if (view.result.accepted()) view.counted = updater.add_view(view.result.T_map_local, list);
    done.views.push_back(std::move(view));
    if (static_cast<std::int64_t>(done.views.size()) % arguments.every != 0) continue;
    matcher = matcher_over(arguments, updater.update().stems_in_map_m);
  }
  done.update = updater.update();
  return done;
}

Json retired_json(const StemCsvFile& map, const std::vector<std::size_t>& retired) {
  Json json = Json::array();
  for (const std::size_t i : retired) {
    Json stem = {{"line", map.line_of(i)},
                 {"x_m", map.stems()[i].position_m.x()},
                 {"y_m", map.stems()[i].position_m.y()}};
    if (!map.id_of(i).empty()) stem["id"] = map.id_of(i);
    json.push_back(std::move(stem));
  }
  return json;
}

Json answer(const UpdateMapArguments& arguments, const StemCsvFile& map, const UpdatedMap& done,
            const Points& added_m) {
  std::size_t accepted = 0, counted = 0;
  Json views = Json::array();
  for (std::size_t i = 0; i < done.views.size(); ++i) {
    const LocateResult& result = done.views[i].result;
    accepted += result.accepted() ? 1 : 0;
    counted += done.views[i].counted ? 1 : 0;
    views.push_back({{"local", arguments.locals[i].string()},
                     {"verdict", verdict_name(result.verdict)},
                     {"counted", done.views[i].counted}});
  }
  Json added = Json::array();
  for (const Eigen::Vector2d& stem_m : added_m) {
    added.push_back({{"x_m", stem_m.x()}, {"y_m", stem_m.y()}});
  }
  return {{"map", arguments.map.string()},
          {"out", arguments.out.string()},
          {"method", arguments.method},
          {"lists", done.views.size()},
          {"accepted", accepted},
          {"refused", done.views.size() - accepted},
          {"counted", counted},
          {"stems_before", map.stems().size()},
          {"stems_after", done.update.stems_in_map_m.size()},
          {"retired", retired_json(map, done.update.retired)},
          {"added", added},
          {"detection_rate", done.update.detection_rate},
          {"views", views}};
}

void print_text(const Json& json) {
  fmt::print("{} of {} lists accepted by {}, {} counted as views of their own\n",
             std::size_t{json["accepted"]}, std::size_t{json["lists"]}, std::string{json["method"]},
             std::size_t{json["counted"]});
  fmt::print("{}: {} stems, {} retired and {} added: {} in {}\n", std::string{json["map"]},
             std::size_t{json["stems_before"]}, json["retired"].size(), json["added"].size(),
             std::size_t{json["stems_after"]}, std::string{json["out"]});
}

}  // namespace

int update_map_verb(const UpdateMapArguments& arguments) {
  check_finite("--tolerance-m2", arguments.tolerance_m2);
  check_finite("--range-m", arguments.range_m);
  check_finite("--view-deg", arguments.field_of_view_deg);
  const StemCsvFile map(arguments.map);
  std::vector<Points> lists;
  for (const auto& file : arguments.locals) {
    lists.push_back(places_of(read_stem_csv(file, StemList::kMayBeEmpty)));
  }
  const UpdatedMap done = update_by(arguments, places_of(map.stems()), lists);
  const Points& stems_m = done.update.stems_in_map_m;
  const Points added_m(stems_m.end() - static_cast<std::ptrdiff_t>(done.update.added),
                       stems_m.end());
  write_file_safely(arguments.out, map.changed(done.update.retired, added_m));
  const Json json = answer(arguments, map, done, added_m);
  if (arguments.json) {
    fmt::print("{}\n", json.dump());
  } else {
    print_text(json);
  }
  return 0;
}

}  // namespace honka::eval
