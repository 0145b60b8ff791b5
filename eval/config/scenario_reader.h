#pragma once

#include "algo/types/settings.h"
#include "eval/config/toml_source.h"

namespace honka::eval {

/// Writes located values into the settings it visits. Kinds, ranges and choices are checked.
class ScenarioReader : public SettingsVisitor {
 public:
  explicit ScenarioReader(const LocatedValues& values) : values_(values) {}

  void field(const Field& field, double& value, Range range) override;
  void field(const Field& field, std::int64_t& value, Range range) override;
  void field(const Field& field, bool& value) override;
  void field(const Field& field, std::string& value, const Choices& choices) override;
  void field(const Field& field, std::vector<double>& value, Range range) override;
  void field(const Field& field, std::vector<std::int64_t>& value, Range range) override;
  void group(std::string_view name, const std::function<void()>& fields) override;

  /// UserError for the first value (in order of key) that no setting asked for.
  void check_all_read() const;

 private:
  const LocatedValue* take(const Field& field);

  const LocatedValues& values_;
  std::string prefix_;
  std::vector<std::string> known_;
};

}  // namespace honka::eval
