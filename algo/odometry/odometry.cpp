#include "algo/odometry/odometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "algo/odometry/loam/loam.h"
#include "algo/odometry/stems/stem_odometry.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using OdometryFactory = std::unique_ptr<Odometry> (*)(const LidarModel&,
                                                      const LidarOdometrySettings&);

struct OdometryEntry {
  std::string_view name;
  OdometryFactory create;
};

// One line for each odometry.
constexpr std::array kOdometries = {
    OdometryEntry{
        "loam",
        [](const LidarModel& model, const LidarOdometrySettings& s) -> std::unique_ptr<Odometry> {
          return std::make_unique<LoamOdometry>(model, s.loam);
        }},
    OdometryEntry{
        "stems",
        [](const LidarModel& model, const LidarOdometrySettings& s) -> std::unique_ptr<Odometry> {
          return std::make_unique<StemOdometry>(model, s.stems);
        }},
};

}  // namespace

std::string_view name_of(OdometryStatus status) {
  constexpr std::array<std::string_view, 4> kNames = {"registered", "degenerate", "predicted",
                                                      "refused"};
  return kNames.at(static_cast<std::size_t>(status));
}

std::string_view name_of(OdometryCause cause) {
  constexpr std::array<std::string_view, 10> kNames = {
      "none",       "gap",          "repeated_time", "reversed_time", "not_finite",
      "empty_scan", "few_features", "unobserved",    "not_converged", "jump"};
  return kNames.at(static_cast<std::size_t>(cause));
}

void describe(SettingsVisitor& v, LidarOdometrySettings& s) {
  v.group("loam", [&] { describe(v, s.loam); });
  v.group("stems", [&] { describe(v, s.stems); });
}

const std::vector<std::string>& odometry_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const OdometryEntry& entry : kOdometries) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

std::unique_ptr<Odometry> create_odometry(std::string_view name, const LidarModel& model,
                                          const LidarOdometrySettings& settings) {
  const auto* entry = std::find_if(kOdometries.begin(), kOdometries.end(),
                                   [&](const OdometryEntry& e) { return e.name == name; });
  if (entry == kOdometries.end()) {
    throw UserError(fmt::format("no odometry is called \"{}\"; choose one of: {}", name,
                                fmt::join(odometry_names(), ", ")));
  }
  return entry->create(model, settings);
}

}  // namespace honka
