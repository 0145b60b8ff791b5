// Input that is small, odd or wrong.
#include <catch2/catch.hpp>
#include <limits>
#include <map>

#include "algo/localize/matcher.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

using Points = std::vector<Eigen::Vector2d>;

Points scatter(int n, std::uint64_t seed) {
  RandomStream stream(seed, "localize_input_test");
  Points stems;
  for (int i = 0; i < n; ++i) {
    const double x = stream.uniform(0.0, 50.0);
    stems.emplace_back(x, stream.uniform(0.0, 50.0));
  }
  return stems;
}

std::unique_ptr<Matcher> matcher(const Points& map) { return create_matcher("li2020", map, {}); }

/// Collects keys; changes nothing.
class KeyList : public SettingsVisitor {
 public:
  void field(const Field& f, double&, Range) override { add(f); }
  void field(const Field& f, std::int64_t&, Range) override { add(f); }
  void field(const Field& f, bool&) override { add(f); }
  void field(const Field& f, std::string& value, const Choices& choices) override {
    add(f);
    CHECK(std::count(choices.begin(), choices.end(), value) == 1);
  }
  void field(const Field& f, std::vector<double>&, Range) override { add(f); }
  void field(const Field& f, std::vector<std::int64_t>&, Range) override { add(f); }
  void group(std::string_view name, const std::function<void()>& fields) override {
    const std::string before = prefix_;
    prefix_ += std::string(name) + ".";
    fields();
    prefix_ = before;
  }

  std::map<std::string, int> keys;

 private:
  void add(const Field& f) {
    CHECK_FALSE(f.help.empty());
    CHECK_FALSE(f.source.empty());
    ++keys[prefix_ + std::string(f.key)];
  }
  std::string prefix_;
};

}  // namespace

TEST_CASE("verdict names") {
  CHECK(verdict_name(Verdict::kAccepted) == "accepted");
  CHECK(verdict_name(Verdict::kAmbiguous) == "ambiguous");
  CHECK(verdict_name(Verdict::kNotInMap) == "not_in_map");
  CHECK(verdict_name(Verdict::kTooFewStems) == "too_few_stems");
}

TEST_CASE("few, equal or collinear stems are too few") {
  const auto m = matcher(scatter(100, 1));
  Points line;
  for (int i = 0; i < 30; ++i) line.emplace_back(i, 2.0 * i);
  const Points same(30, Eigen::Vector2d(3, 4));
  for (const Points& local : {Points{}, scatter(1, 2), scatter(2, 2), scatter(5, 2), line, same}) {
    const auto answer = m->locate(local);
    CHECK(answer.verdict == Verdict::kTooFewStems);
    CHECK(answer.stems == static_cast<int>(local.size()));
    CHECK(answer.matches == 0);
    CHECK(answer.chosen == -1);
    CHECK(answer.T_map_local.translation_m.norm() == 0.0);
  }
}

TEST_CASE("repeated stems change nothing but the count") {
  const Points map = scatter(200, 1);
  Points local(map.begin(), map.end());
  const auto once = matcher(map)->locate(local);
  local.insert(local.end(), map.begin(), map.begin() + 50);
  const auto twice = matcher(map)->locate(local);
  CHECK(once.accepted());
  CHECK(twice.stems == once.stems + 50);
  CHECK(twice.matches == once.matches);
  CHECK(twice.T_map_local.translation_m == once.T_map_local.translation_m);
}

TEST_CASE("a map smaller than the frame is an answerable question") {
  const Points local = scatter(200, 1);
  Points map;
  for (const auto& p : local) {
    if ((p - Eigen::Vector2d(25, 25)).norm() < 15.0) map.push_back(p);
  }
  REQUIRE(map.size() < local.size() / 2);
  const auto answer = matcher(map)->locate(local);
  CHECK(answer.accepted());
  CHECK(answer.T_map_local.translation_m.norm() < 1e-6);
}

TEST_CASE("a planted grid gives an answer, and the same one again") {
  Points rows;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) rows.emplace_back(2.5 * i, 2.0 * j);
  }
  const auto first = matcher(rows)->locate(rows);
  const auto second = matcher(rows)->locate(rows);
  CHECK(first.matches > 0);
  CHECK(first.T_map_local.translation_m == second.T_map_local.translation_m);
}

TEST_CASE("coordinates that are not finite are refused") {
  Points stems = scatter(50, 1);
  const auto m = matcher(stems);
  stems[30].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(m->locate(stems), Catch::Contains("point 31 of 50"));
  CHECK_THROWS_AS(matcher(stems), UserError);
}

TEST_CASE("a map that holds no star is refused with its size") {
  for (const int n : {0, 1, 2, 4}) CHECK_THROWS_AS(matcher(scatter(n, 1)), UserError);
  CHECK_THROWS_WITH(matcher(scatter(2, 1)), Catch::Contains("the map has 2 stems"));
}

TEST_CASE("unknown words are refused with the choices") {
  const Points map = scatter(50, 1);
  CHECK_THROWS_WITH(create_matcher("li2021", map, {}), Catch::Contains("li2020"));
  LocalizeSettings settings;
  settings.li2020.pairing = "edge";
  CHECK_THROWS_WITH(create_matcher("li2020", map, settings), Catch::Contains("least_side_sum"));
  settings = {};
  settings.li2020.selection = "boxes";
  CHECK_THROWS_WITH(create_matcher("li2020", map, settings), Catch::Contains("candidates"));
}

TEST_CASE("every setting is described once, with help and source") {
  LocalizeSettings settings;
  KeyList list;
  describe(list, settings);
  CHECK(list.keys.size() == 18);
  for (const auto& [key, times] : list.keys) CHECK(times == 1);
  CHECK(list.keys.count("method") == 1);
  CHECK(list.keys.count("li2020.tolerance_m2") == 1);
}

TEST_CASE("every registered matcher can be made and answers") {
  const Points map = scatter(200, 1);
  for (const auto& name : matcher_names()) {
    const auto answer = create_matcher(name, map, {})->locate(map);
    CHECK(answer.accepted());
    CHECK(answer.T_map_local.translation_m.norm() < 1e-6);
  }
}
