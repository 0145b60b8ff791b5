// The cases of the study of stem lists, from lists side by side.
#include <catch2/catch.hpp>

#include "algo/types/user_error.h"
#include "eval/config/sighting_study_settings.h"
#include "eval/config/words.h"

using namespace honka;
using namespace honka::eval;

TEST_CASE("without lists there is one case, with the values of the study") {
  SightingStudySettings settings;
  settings.detector.noise_m = 0.3;
  settings.map.stems = 500;
  const auto cases = sighting_cases(settings);
  REQUIRE(cases.size() == 1);
  CHECK(cases[0].name == "all");
  CHECK(cases[0].detector.noise_m == 0.3);
  CHECK(cases[0].map.stems == 500);
  CHECK(cases[0].queries == settings.queries);
}

TEST_CASE("each case takes its entry of every list, and is named by what differs") {
  SightingStudySettings settings;
  settings.detector.missed_share = 0.4;
  settings.cases.noise_m = {0.15, 0.5};
  settings.cases.false_share = {0.0, 0.2};
  settings.cases.most_stems = {0, 14};
  settings.cases.stems_in_map = {2200, 1000000};
  settings.cases.queries = {1000, 300};
  const auto cases = sighting_cases(settings);
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].name == "2200 stems in the map, noise 0.15 m");
  CHECK(cases[1].name == "1000000 stems in the map, noise 0.5 m, 20 % false, 14 stems");
  CHECK(cases[1].detector.most_stems == 14);
  CHECK(cases[1].detector.missed_share == 0.4);
  CHECK(cases[1].map.stems == 1000000);
  CHECK(cases[1].queries == 300);
}

TEST_CASE("a case of which no list says anything is that of every tree in view") {
  SightingStudySettings settings;
  settings.cases.missed_share = {0.0, 0.3};
  CHECK(sighting_cases(settings).front().name == "every tree in view");
}

TEST_CASE("lists of different lengths are the user's mistake, by name") {
  SightingStudySettings settings;
  settings.cases.noise_m = {0.15, 0.5};
  settings.cases.false_share = {0.1, 0.2, 0.3};
  CHECK_THROWS_WITH(sighting_cases(settings),
                    Catch::Contains("sighting.cases.false_share: 3 entries"));
}

TEST_CASE("words stand between commas and blanks") {
  CHECK(words_of("li2020, consensus") == std::vector<std::string>{"li2020", "consensus"});
  CHECK(words_of(" a,,b ") == std::vector<std::string>{"a", "b"});
  CHECK(words_of("").empty());
}
