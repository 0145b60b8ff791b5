#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "algo/localize/matcher.h"
#include "tests/support/stem_csv.h"

namespace honka::test {

/// The cases that are committed.
inline std::filesystem::path own_cases() {
  return std::filesystem::path(HONKA_SOURCE_DIR) / "tests/data/localization_cases";
}

/// The full set, where it is at hand.
inline std::optional<std::filesystem::path> shared_cases() {
  const auto folder =
      std::filesystem::path(HONKA_SOURCE_DIR).parent_path() / "shared/data/localization_cases";
  if (!std::filesystem::exists(folder)) return std::nullopt;
  return folder;
}

inline nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  return nlohmann::json::parse(in);
}

/// Li2020 with the tolerance that belongs to a set.
inline LocalizeSettings settings_for(const std::string& set) {
  LocalizeSettings settings;
  settings.li2020.tolerance_m2 = set == "exact" ? 0.001 : 9.0;
  return settings;
}

/// Matcher on the map of a set.
inline std::unique_ptr<Matcher> matcher_for(const std::filesystem::path& folder,
                                            const std::string& set) {
  return create_matcher("li2020", read_stems(folder / set / "map.csv"), settings_for(set));
}

}  // namespace honka::test
