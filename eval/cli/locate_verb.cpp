#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "algo/localize/consensus/consensus.h"
#include "algo/types/user_error.h"
#include "eval/cli/index_file.h"
#include "eval/cli/locate_prior.h"
#include "eval/cli/verbs.h"
#include "eval/io/csv.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {
namespace {

using Places = std::vector<Eigen::Vector3d>;

/// Where the stems stand; 0 for heights that are not there, which nothing asks for.
Places read_places(const std::filesystem::path& file, StemList list,
                   const LocateArguments& arguments) {
  const bool in_space = arguments.stars == "space";
  Places places;
  for (const Stem& stem :
       read_stem_csv(file, list, in_space ? StemHeights::kNeeded : StemHeights::kOptional)) {
    places.emplace_back(stem.position_m.x(), stem.position_m.y(), stem.z_m.value_or(0.0));
  }
  return places;
}

/// Roll and pitch of R = Rz(yaw) Ry(pitch) Rx(roll).
double roll_of(const Eigen::Matrix3d& R) { return std::atan2(R(2, 1), R(2, 2)); }
double pitch_of(const Eigen::Matrix3d& R) { return std::asin(std::clamp(-R(2, 0), -1.0, 1.0)); }

nlohmann::ordered_json answer(const std::filesystem::path& local, const std::string& method,
                              bool in_space, const LocateResult& result, double time_ms) {
  nlohmann::ordered_json json;
  json["local"] = local.string();
  json["method"] = method;
  json["verdict"] = verdict_name(result.verdict);
  json["accepted"] = result.accepted();
  const bool accepted = result.accepted();
  const auto or_null = [&](double value) {
    return accepted ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  json["x_m"] = or_null(result.T_map_local.translation_m.x());
  json["y_m"] = or_null(result.T_map_local.translation_m.y());
  json["yaw_rad"] = or_null(result.T_map_local.yaw_rad);
  if (in_space) {
    const Pose3 T_map_local = result.T_map_local_3d.value_or(Pose3::Identity());
    json["z_m"] = or_null(T_map_local.translation().z());
    json["roll_rad"] = or_null(roll_of(T_map_local.linear()));
    json["pitch_rad"] = or_null(pitch_of(T_map_local.linear()));
  }
  json["stems"] = result.stems;
  json["matches"] = result.matches;
  json["agreeing"] = result.agreeing;
  json["inliers"] = result.inliers;
  json["margin"] = result.margin;
  json["time_ms"] = time_ms;
  return json;
}

void print_text(const nlohmann::ordered_json& json) {
  const std::string local = json["local"];
  if (json["accepted"]) {
    fmt::print("{}: x {:.3f} m, y {:.3f} m, yaw {:.5f} rad", local, double{json["x_m"]},
               double{json["y_m"]}, double{json["yaw_rad"]});
    if (json.contains("z_m")) {
      fmt::print(", z {:.3f} m, roll {:.5f} rad, pitch {:.5f} rad", double{json["z_m"]},
                 double{json["roll_rad"]}, double{json["pitch_rad"]});
    }
  } else {
    fmt::print("{}: refused, {}", local, std::string{json["verdict"]});
  }
  fmt::print(" ({} stems, {} matches, {} agree, {:.1f} ms)\n", int{json["stems"]},
             int{json["matches"]}, int{json["agreeing"]}, double{json["time_ms"]});
}

/// The matcher over the map, and how long its graph or index took.
struct MapMatcher {
  std::unique_ptr<Matcher> matcher;
  double map_ms = 0.0;
};

/// With the index of a file; written where the file holds none of this map.
MapMatcher matcher_by_file(const LocateArguments& arguments, const Places& map) {
  const Stopwatch watch;
  const IndexFromFile file = load_or_build_index(arguments.index, plan_of(map));
  MapMatcher result{std::make_unique<ConsensusMatcher>(file.index, LocalizeSettings{}.consensus),
                    0.0};
  result.map_ms = watch.milliseconds();
  if (file.foreign) {
    fmt::print(stderr, "note: {} holds the index of another map; it is replaced\n",
               arguments.index.string());
  }
  if (!file.loaded) write_index_file(arguments.index, *file.index);
  return result;
}

/// The matcher's complaint about the stems names their file.
MapMatcher make_map_matcher(const LocateArguments& arguments, const Places& map) {
  LocalizeSettings settings;
  settings.method = arguments.method;
  settings.li2020.tolerance_m2 = arguments.tolerance_m2;
  settings.li2020.stars = arguments.stars.value_or("plane");
  const auto names = matcher_names();
  const bool known = std::find(names.begin(), names.end(), arguments.method) != names.end();
  if (!arguments.index.empty() && arguments.method == "consensus") {
    return matcher_by_file(arguments, map);
  }
  try {
    const Stopwatch watch;
    MapMatcher result{create_matcher(arguments.method, map, settings), 0.0};
    result.map_ms = watch.milliseconds();
    return result;
  } catch (const UserError& error) {
    throw UserError((known ? arguments.map.string() : "--method") + ": " + error.what());
  }
}

void check_arguments(const LocateArguments& arguments) {
  if (!std::isfinite(arguments.tolerance_m2)) {
    throw UserError("--tolerance-m2: must be a finite number of square metres, such as 4.5");
  }
  if (!arguments.index.empty() && arguments.method != "consensus") {
    throw UserError("--index: only the method consensus keeps an index; add --method consensus, " +
                    std::string("or leave --index out"));
  }
  if (arguments.stars && arguments.method != "li2020") {
    throw UserError(std::string("--stars: only the method li2020 compares stars; ") +
                    "add --method li2020, or leave --stars out");
  }
}

}  // namespace

int locate_verb(const LocateArguments& arguments) {
  check_arguments(arguments);
  std::optional<LocatePrior> prior;
  if (arguments.prior) prior = parse_prior(*arguments.prior);
  const Places map = read_places(arguments.map, StemList::kHasStems, arguments);
  std::vector<Places> locals;
  for (const auto& file : arguments.locals) {
    locals.push_back(read_places(file, StemList::kMayBeEmpty, arguments));
  }
  const MapMatcher by_map = make_map_matcher(arguments, map);

  for (std::size_t i = 0; i < locals.size(); ++i) {
    const Stopwatch watch;
    const LocateResult result = by_map.matcher->locate(locals[i], prior);
    auto json = answer(arguments.locals[i], arguments.method, arguments.stars == "space", result,
                       watch.milliseconds());
    if (i == 0) json["map_ms"] = by_map.map_ms;
    if (arguments.json) {
      fmt::print("{}\n", json.dump());
    } else {
      print_text(json);
    }
  }
  return 0;
}

}  // namespace honka::eval
