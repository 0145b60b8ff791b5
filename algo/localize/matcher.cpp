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
using Factory = std::unique_ptr<Matcher> (*)(const Stems&, const LocalizeSettings&);

struct Entry {
  std::string_view name;
  Factory create;
};

// One line for each matcher.
constexpr std::array kMatchers = {
    Entry{"li2020",
          [](const Stems& map, const LocalizeSettings& s) -> std::unique_ptr<Matcher> {
            if (s.li2020.submap_size_m > 0.0) {
              return std::make_unique<SubmapMatcher>(map, s.li2020);
            }
            return std::make_unique<Li2020Matcher>(map, s.li2020);
          }},
    Entry{"consensus",
          [](const Stems& map, const LocalizeSettings& s) -> std::unique_ptr<Matcher> {
            return std::make_unique<ConsensusMatcher>(std::make_shared<ConsensusIndex>(map),
                                                      s.consensus);
          }},
};

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

std::unique_ptr<Matcher> create_matcher(std::string_view method, const Stems& stems_in_map_m,
                                        const LocalizeSettings& settings) {
  const auto* entry = std::find_if(kMatchers.begin(), kMatchers.end(),
                                   [&](const Entry& e) { return e.name == method; });
  if (entry == kMatchers.end()) {
    throw UserError(fmt::format("no matcher is called \"{}\"; choose one of: {}", method,
                                fmt::join(matcher_names(), ", ")));
  }
  return entry->create(stems_in_map_m, settings);
}

}  // namespace honka
