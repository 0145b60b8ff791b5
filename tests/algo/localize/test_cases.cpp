#include <catch2/catch.hpp>
#include <cmath>

#include "tests/algo/localize/cases.h"

using namespace honka;
using namespace honka::test;

namespace {

struct Tally {
  int cases = 0;
  int right = 0;  ///< accepted, and within the bound of the true pose
  int wrong = 0;  ///< accepted, and not
};

Tally locate_all(const std::filesystem::path& folder, const std::string& set, double bound_m,
                 double bound_rad) {
  const auto matcher = matcher_for(folder, set);
  Tally tally;
  for (const CasePose& truth : read_case_poses(folder / set / "poses.csv")) {
    const auto answer = matcher->locate(read_stems(folder / set / (truth.name + ".csv")));
    const Pose2 error = truth.T_map_local.inverse() * answer.T_map_local;
    ++tally.cases;
    if (!answer.accepted()) continue;
    const bool close = error.translation_m.norm() < bound_m && std::abs(error.yaw_rad) < bound_rad;
    ++(close ? tally.right : tally.wrong);
  }
  return tally;
}

}  // namespace

TEST_CASE("exact cases: every pose within 1e-4 m and 1e-5 rad") {
  const Tally tally = locate_all(own_cases(), "exact", 1e-4, 1e-5);
  CHECK(tally.cases == 7);
  CHECK(tally.right == 7);
}

TEST_CASE("easy cases: all right but one, which has two agreeing matches and is refused") {
  const Tally tally = locate_all(own_cases(), "easy", 0.5, deg_to_rad(2.5));
  CHECK(tally.cases == 7);
  CHECK(tally.right == 6);
  CHECK(tally.wrong == 0);
  const auto refused = matcher_for(own_cases(), "easy")
                           ->locate(read_stems(own_cases() / "easy" / "easy_n1_k12.csv"));
  CHECK(refused.agreeing == 2);
  CHECK(refused.verdict == Verdict::kNotInMap);
}

TEST_CASE("the full set of localization cases") {
  const auto folder = shared_cases();
  if (!folder) {
    WARN("skipped: shared/data/localization_cases is not here");
    return;
  }
  const Tally exact = locate_all(*folder, "exact", 1e-4, 1e-5);
  CHECK(exact.cases == 52);
  CHECK(exact.right == 52);
  const Tally easy = locate_all(*folder, "easy", 0.5, deg_to_rad(2.5));
  CHECK(easy.cases == 52);
  CHECK(easy.right == 51);
  CHECK(easy.wrong == 0);
}

TEST_CASE("counts and cost equal those of the independent implementation") {
  const auto folder = shared_cases();
  if (!folder) {
    WARN("skipped: shared/data/localization_cases is not here");
    return;
  }
  for (const std::string set : {"exact", "easy"}) {
    const auto matcher = matcher_for(*folder, set);
    const auto file = read_json(*folder / ("cases_" + set + ".json"));
    REQUIRE(file["cases"].size() == 52);
    for (const auto& row : file["cases"]) {
      const auto name = row["id"].get<std::string>();
      const auto answer = matcher->locate(read_stems(*folder / set / (name + ".csv")));
      const auto& oracle = row["oracle"];
      INFO(name);
      CHECK(answer.stems == static_cast<int>(row["stems"].size()));
      CHECK(answer.local_stars == oracle["n_local_stars"]);
      CHECK(answer.candidates == oracle["n_candidates"]);
      CHECK(answer.matches == oracle["n_match"]);
      CHECK(answer.agreeing == oracle["n_agree"]);
      CHECK(answer.cost_m == Approx(oracle["eq4_cost"].get<double>()).margin(1e-6));
      CHECK(answer.T_map_local.yaw_rad == Approx(oracle["theta"].get<double>()).margin(1e-9));
    }
  }
}
