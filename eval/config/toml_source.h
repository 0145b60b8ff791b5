#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eval/config/value.h"

namespace honka::eval {

/// A value with the place it came from: "scenarios/quick.toml:12:9" or "-s
/// forest.density_per_ha=3".
struct LocatedValue {
  Value value;
  std::string place;
  int line = 0, column = 0;  ///< of a file, from 1; 0 for a value of the command line
};

/// Keys (with their groups, dotted) and values of a scenario file.
using LocatedValues = std::map<std::string, LocatedValue>;

/// Reads a TOML file. UserError with file, line and column where it is missing or broken, and where
/// a value is of a kind that no setting has (dates, mixed lists).
[[nodiscard]] LocatedValues read_toml(const std::filesystem::path& file);

/// Reads "key=value" as -s gives it; the value as in TOML, bare words as text.
[[nodiscard]] std::pair<std::string, LocatedValue> parse_override(const std::string& text);

}  // namespace honka::eval
