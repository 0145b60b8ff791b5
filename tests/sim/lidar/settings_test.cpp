#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "sim/lidar/lidar_settings.h"

namespace honka::sim {
namespace {

/// Collects the keys; checks that every default is one that its own description allows.
class Keys : public SettingsVisitor {
 public:
  void field(const Field& f, double& v, Range r) override { add(f, v >= r.low && v <= r.high); }
  void field(const Field& f, std::int64_t& v, Range r) override {
    const auto value = static_cast<double>(v);
    add(f, value >= r.low && value <= r.high);
  }
  void field(const Field& f, bool&) override { add(f, true); }
  void field(const Field& f, std::string& v, const Choices& choices) override {
    bool known = choices.empty();
    for (const std::string& choice : choices) known = known || choice == v;
    add(f, known);
  }
  void field(const Field& f, std::vector<double>&, Range) override { add(f, true); }
  void field(const Field& f, std::vector<std::int64_t>&, Range) override { add(f, true); }
  void group(std::string_view, const std::function<void()>& fields) override { fields(); }
  std::set<std::string> keys;

 private:
  void add(const Field& f, bool allowed) {
    CHECK(allowed);
    CHECK(keys.insert(std::string(f.key)).second);
    CHECK((!f.help.empty() && !f.source.empty()));
  }
};

}  // namespace

TEST_CASE("every setting of the lidar has one key, a source, and an allowed default") {
  LidarSettings settings;
  Keys keys;
  describe(keys, settings);
  CHECK(keys.keys.size() == 15);
}

}  // namespace honka::sim
