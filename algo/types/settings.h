#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace honka {

/// What a setting is: its key in the scenario file, its unit and where its default comes from.
struct Field {
  std::string_view key;
  std::string_view unit;    ///< "m", "deg", "1/ha", "" for none
  std::string_view help;    ///< one line
  std::string_view source;  ///< paper, manual, data set, or "choice"
};

/// Closed interval that a number must lie in.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Words that a text may be; empty for free text.
using Choices = std::vector<std::string>;

/// Walks over settings. Beside each settings struct stands `describe(visitor, settings)`, which
/// names every field once; the reader, `scenario show`, the range checks, the hash and the key
/// reference are visitors of it.
class SettingsVisitor {
 public:
  virtual ~SettingsVisitor() = default;

  virtual void field(const Field& field, double& value, Range range) = 0;
  virtual void field(const Field& field, std::int64_t& value, Range range) = 0;
  virtual void field(const Field& field, bool& value) = 0;
  virtual void field(const Field& field, std::string& value, const Choices& choices) = 0;
  virtual void field(const Field& field, std::vector<double>& value, Range range) = 0;
  virtual void field(const Field& field, std::vector<std::int64_t>& value, Range range) = 0;

  /// Fields named inside `fields` have keys below `name`: group("forest", …) → forest.density…
  virtual void group(std::string_view name, const std::function<void()>& fields) = 0;
};

}  // namespace honka
