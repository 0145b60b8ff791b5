#include "eval/study/trial_record.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace {

using namespace honka::eval;

TrialRecord full_record() {
  TrialRecord record;
  record.id = {3, 417};
  record.results = {{"li2020", {1.0, 0.1 + 0.2, -0.0, 5e-324}}, {"consensus", {}}};
  record.wall_s = 1.0 / 3.0;
  record.cpu_s = 1e300;
  record.resident_bytes = 123456789012;
  return record;
}

}  // namespace

TEST_CASE("a record comes back from its line with every digit") {
  const TrialRecord record = full_record();
  const auto back = from_line(to_line(record));
  REQUIRE(back);
  CHECK(*back == record);
  CHECK(std::signbit(back->results[0].values[2]));
}

TEST_CASE("missing numbers come back as missing") {
  TrialRecord record = full_record();
  record.results[0].values[1] = std::numeric_limits<double>::quiet_NaN();
  record.results[0].values[2] = std::numeric_limits<double>::infinity();
  const auto back = from_line(to_line(record));
  REQUIRE(back);
  CHECK(std::isnan(back->results[0].values[1]));
  CHECK(back->results[0].values[2] == std::numeric_limits<double>::infinity());
}

TEST_CASE("a cause stays on one line and in one cell") {
  TrialRecord record;
  record.status = TrialStatus::kThrew;
  record.cause = "first\tline\nsecond";
  const std::string line = to_line(record);
  CHECK(line.find('\n') == std::string::npos);
  const auto back = from_line(line);
  REQUIRE(back);
  CHECK(back->cause == "first line second");
  CHECK(back->status == TrialStatus::kThrew);
  CHECK(back->results.empty());
}

TEST_CASE("a line that was cut short or changed anywhere is noticed") {
  const std::string line = to_line(full_record());
  for (std::size_t length = 0; length < line.size(); ++length) {
    CHECK_FALSE(from_line(std::string_view(line).substr(0, length)));
  }
  for (std::size_t k = 0; k < line.size(); ++k) {
    std::string changed = line;
    changed[k] = changed[k] == '7' ? '8' : '7';
    INFO(k);
    CHECK_FALSE(from_line(changed));
  }
  CHECK_FALSE(from_line(line + "\t1"));
}
