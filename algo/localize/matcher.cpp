#include "algo/localize/matcher.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/localize/consensus/consensus.h"
#include "algo/localize/li2020/li2020.h"
#include "algo/localize/li2020/submaps.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

using Stems = std::vector<Eigen::Vector2d>;
using StemsWithHeights = std::vector<Eigen::Vector3d>;

struct Entry {
  std::string_view name;
  std::unique_ptr<Matcher> (*create)(const Stems&, const LocalizeSettings&);
  /// Of a matcher that can ask for heights; null where settings do not ask.
  std::unique_ptr<Matcher> (*create_with_heights)(const StemsWithHeights&,
                                                  const LocalizeSettings&) = nullptr;
};

template <int D>
std::unique_ptr<Matcher> make_li2020(const StarPoints<D>& map, const Li2020Settings& settings) {
  if (settings.submap_size_m > 0.0) return std::make_unique<SubmapMatcherIn<D>>(map, settings);
  return std::make_unique<Li2020MatcherIn<D>>(map, settings);
}

// One line for each matcher.
constexpr std::array kMatchers = {
    Entry{"li2020",
          [](const Stems& map, const LocalizeSettings& s) { return make_li2020<2>(map, s.li2020); },
          [](const StemsWithHeights& map, const LocalizeSettings& s) -> std::unique_ptr<Matcher> {
            return s.li2020.stars == "space" ? make_li2020<3>(map, s.li2020) : nullptr;
          }},
    Entry{"consensus",
          [](const Stems& map, const LocalizeSettings& s) -> std::unique_ptr<Matcher> {
            return std::make_unique<ConsensusMatcher>(std::make_shared<ConsensusIndex>(map),
                                                      s.consensus);
          }},
};

const Entry& entry_of(std::string_view method) {
  const auto* entry = std::find_if(kMatchers.begin(), kMatchers.end(),
                                   [&](const Entry& e) { return e.name == method; });
  if (entry != kMatchers.end()) return *entry;
  throw UserError(fmt::format("no matcher is called \"{}\"; choose one of: {}", method,
                              fmt::join(matcher_names(), ", ")));
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> kNames = {"accepted", "ambiguous", "not_in_map",
                                                      "too_few_stems"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

void check_prior(const std::optional<LocatePrior>& prior) {
  if (!prior) return;
  const bool finite = prior->position_in_map_m.allFinite() && std::isfinite(prior->radius_m);
  if (finite && prior->radius_m > 0.0) return;
  throw UserError(
      fmt::format("the prior {}, {} with radius {} m is not a place: give x, y and a "
                  "radius above 0",
                  prior->position_in_map_m.x(), prior->position_in_map_m.y(), prior->radius_m));
}

const std::vector<std::string>& matcher_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Entry& entry : kMatchers) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

void describe(SettingsVisitor& v, LocalizeSettings& s) {
  v.field({"method", "", "matcher that answers", "Li2020 §2.8"}, s.method, matcher_names());
  v.group("li2020", [&] { describe(v, s.li2020); });
  v.group("consensus", [&] { describe(v, s.consensus); });
}

std::vector<Eigen::Vector2d> plan_of(const std::vector<Eigen::Vector3d>& stems_m) {
  std::vector<Eigen::Vector2d> plan_m;
  plan_m.reserve(stems_m.size());
  for (const Eigen::Vector3d& stem : stems_m) {
    if (!std::isfinite(stem.z())) {
      throw UserError(
          fmt::format("stem {} of {} has the height {}: give its z in metres, or leave "
                      "all heights out",
                      plan_m.size() + 1, stems_m.size(), stem.z()));
    }
    plan_m.emplace_back(stem.head<2>());
  }
  return plan_m;
}

LocateResult Matcher::locate(const std::vector<Eigen::Vector2d>&,
                             const std::optional<LocatePrior>&) const {
  throw UserError("the list has stems without heights, and the matcher compares them in space; " +
                  std::string("give z_m of each, or set li2020.stars to \"plane\""));
}

LocateResult Matcher::locate(const std::vector<Eigen::Vector3d>& stems_in_local_m,
                             const std::optional<LocatePrior>& prior) const {
  return locate(plan_of(stems_in_local_m), prior);
}

std::unique_ptr<Matcher> create_matcher(std::string_view method, const Stems& stems_in_map_m,
                                        const LocalizeSettings& settings) {
  return entry_of(method).create(stems_in_map_m, settings);
}

std::unique_ptr<Matcher> create_matcher(std::string_view method,
                                        const StemsWithHeights& stems_in_map_m,
                                        const LocalizeSettings& settings) {
  const Entry& entry = entry_of(method);
  if (entry.create_with_heights != nullptr) {
    auto matcher = entry.create_with_heights(stems_in_map_m, settings);
    if (matcher) return matcher;
  }
  return entry.create(plan_of(stems_in_map_m), settings);
}

}  // namespace honka
