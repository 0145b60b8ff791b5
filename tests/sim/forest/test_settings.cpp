#include <catch2/catch.hpp>
#include <set>

#include "sim/forest/forest.h"

using namespace honka;

namespace {

/// Checks every field's description and that its default lies in its range.
class Inspector : public SettingsVisitor {
 public:
  void field(const Field& f, double& value, Range range) override { number(f, value, range); }
  void field(const Field& f, std::int64_t& value, Range range) override {
    number(f, static_cast<double>(value), range);
  }
  void field(const Field& f, bool&) override { name(f); }
  void field(const Field& f, std::string& value, const Choices& choices) override {
    name(f);
    CHECK((choices.empty() || std::count(choices.begin(), choices.end(), value) == 1));
  }
  void field(const Field& f, std::vector<double>& values, Range range) override {
    for (const double value : values) number(f, value, range, false);
    name(f);
  }
  void field(const Field& f, std::vector<std::int64_t>&, Range) override { name(f); }
  void group(std::string_view name, const std::function<void()>& fields) override {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    fields();
    prefix_ = outer;
  }
  std::set<std::string> keys;

 private:
  void name(const Field& f) {
    CAPTURE(prefix_, f.key);
    CHECK(keys.insert(prefix_ + std::string(f.key)).second);
    CHECK_FALSE(f.help.empty());
    CHECK_FALSE(f.source.empty());
  }
  void number(const Field& f, double value, Range range, bool named = true) {
    CAPTURE(prefix_, f.key, value);
    CHECK(value >= range.low);
    CHECK(value <= range.high);
    if (named) name(f);
  }
  std::string prefix_;
};

}  // namespace

TEST_CASE("every key of the forest is described once and its default lies in its range") {
  Inspector inspector;
  sim::ForestSettings settings;
  describe(inspector, settings);
  sim::ThinningSettings thinning;
  inspector.group("thinning", [&] { describe(inspector, thinning); });
  for (const char* key : {"density_per_ha", "stem_map", "corridor_half_width_m", "spacing.process",
                          "spacing.strauss.factors", "spacing.hard_core.core", "trees.dbh_scale_m",
                          "undergrowth.bushes_per_ha", "terrain.relief_m"}) {
    CAPTURE(key);
    CHECK(inspector.keys.count(key) == 1);
  }
}
