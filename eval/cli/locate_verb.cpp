#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "algo/localize/matcher.h"
#include "algo/types/user_error.h"
#include "eval/cli/verbs.h"
#include "eval/io/csv.h"

namespace honka::eval {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<Eigen::Vector2d> positions(const StemMap& stems) {
  std::vector<Eigen::Vector2d> result;
  for (const Stem& stem : stems) result.push_back(stem.position_m);
  return result;
}

nlohmann::ordered_json answer(const std::filesystem::path& local, const std::string& method,
                              const LocateResult& result, double time_ms) {
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
  } else {
    fmt::print("{}: refused, {}", local, std::string{json["verdict"]});
  }
  fmt::print(" ({} stems, {} matches, {} agree, {:.1f} ms)\n", int{json["stems"]},
             int{json["matches"]}, int{json["agreeing"]}, double{json["time_ms"]});
}

/// The matcher over the map; its complaint about the stems names their file.
std::unique_ptr<Matcher> make_matcher(const LocateArguments& arguments, const StemMap& map) {
  LocalizeSettings settings;
  settings.method = arguments.method;
  settings.li2020.tolerance_m2 = arguments.tolerance_m2;
  const auto names = matcher_names();
  const bool known = std::find(names.begin(), names.end(), arguments.method) != names.end();
  try {
    return create_matcher(arguments.method, positions(map), settings);
  } catch (const UserError& error) {
    throw UserError((known ? arguments.map.string() : "--method") + ": " + error.what());
  }
}

}  // namespace

int locate_verb(const LocateArguments& arguments) {
  if (!std::isfinite(arguments.tolerance_m2)) {
    throw UserError("--tolerance-m2: must be a finite number of square metres, such as 4.5");
  }
  const StemMap map = read_stem_csv(arguments.map);
  std::vector<std::vector<Eigen::Vector2d>> locals;
  for (const auto& file : arguments.locals) locals.push_back(positions(read_stem_csv(file)));

  const auto map_start = Clock::now();
  const auto matcher = make_matcher(arguments, map);
  const double map_ms = milliseconds_since(map_start);

  for (std::size_t i = 0; i < locals.size(); ++i) {
    const auto start = Clock::now();
    const LocateResult result = matcher->locate(locals[i]);
    auto json = answer(arguments.locals[i], arguments.method, result, milliseconds_since(start));
    if (i == 0) json["map_ms"] = map_ms;
    if (arguments.json) {
      fmt::print("{}\n", json.dump());
    } else {
      print_text(json);
    }
  }
  return 0;
}

}  // namespace honka::eval
