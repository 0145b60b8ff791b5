#pragma once

#include <map>
#include <string>
#include <vector>

#include "algo/types/settings.h"
#include "eval/config/value.h"

namespace honka::eval {

/// One setting as a scenario file sees it.
struct KeyEntry {
  std::string key;  ///< with its groups: "forest.spacing.process"
  std::string unit, help, source;
  Range range;
  Choices choices;
  Value value;
};

/// Lists every field of a settings struct with its present value, in the order of description.
class KeyTable : public SettingsVisitor {
 public:
  void field(const Field& field, double& value, Range range) override;
  void field(const Field& field, std::int64_t& value, Range range) override;
  void field(const Field& field, bool& value) override;
  void field(const Field& field, std::string& value, const Choices& choices) override;
  void field(const Field& field, std::vector<double>& value, Range range) override;
  void field(const Field& field, std::vector<std::int64_t>& value, Range range) override;
  void group(std::string_view name, const std::function<void()>& fields) override;

  [[nodiscard]] const std::vector<KeyEntry>& entries() const { return entries_; }
  /// The entry of a key; null when there is none.
  [[nodiscard]] const KeyEntry* find(const std::string& key) const;

 private:
  void add(const Field& field, Value value, Range range, Choices choices);

  std::string prefix_;
  std::vector<KeyEntry> entries_;
  std::map<std::string, std::size_t> index_;
};

/// Of `candidates` the one nearest to `word` by edit distance; empty when none is near.
[[nodiscard]] std::string nearest_word(const std::string& word,
                                       const std::vector<std::string>& candidates);

}  // namespace honka::eval
