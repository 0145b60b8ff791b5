#include "eval/config/key_table.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algo/types/check.h"

namespace honka::eval {

void KeyTable::add(const Field& field, Value value, Range range, Choices choices) {
  const std::string key = prefix_ + std::string(field.key);
  HONKA_CHECK(!index_.contains(key), "two settings share the key " + key);
  index_[key] = entries_.size();
  entries_.push_back({key, std::string(field.unit), std::string(field.help),
                      std::string(field.source), range, std::move(choices), std::move(value)});
}

void KeyTable::field(const Field& field, double& value, Range range) {
  add(field, value, range, {});
}
void KeyTable::field(const Field& field, std::int64_t& value, Range range) {
  add(field, value, range, {});
}
void KeyTable::field(const Field& field, bool& value) { add(field, value, {}, {}); }
void KeyTable::field(const Field& field, std::string& value, const Choices& choices) {
  add(field, value, {}, choices);
}
void KeyTable::field(const Field& field, std::vector<double>& value, Range range) {
  add(field, value, range, {});
}
void KeyTable::field(const Field& field, std::vector<std::int64_t>& value, Range range) {
  add(field, value, range, {});
}

void KeyTable::group(std::string_view name, const std::function<void()>& fields) {
  const std::string outer = prefix_;
  prefix_ += std::string(name) + ".";
  fields();
  prefix_ = outer;
}

const KeyEntry* KeyTable::find(const std::string& key) const {
  const auto it = index_.find(key);
  return it == index_.end() ? nullptr : &entries_[it->second];
}

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, change}));
    }
  }
  return row.back();
}

std::string last_part(const std::string& key) { return key.substr(key.find_last_of('.') + 1); }

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(3, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // A right name in a wrong group is nearer than any misspelling.
    const std::size_t distance =
        last_part(candidate) == last_part(word) ? 1 : edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace honka::eval
