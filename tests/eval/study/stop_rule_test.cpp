#include "eval/study/stop_rule.h"

#include <catch2/catch.hpp>

using namespace honka::eval;

namespace {

using Flags = std::vector<std::uint8_t>;

/// 1, 0, 1, 0 …
Flags every_other(std::size_t n) {
  Flags flags(n);
  for (std::size_t i = 0; i < n; ++i) flags[i] = i % 2 == 0;
  return flags;
}

}  // namespace

TEST_CASE("a point ends at the first look at which Wilson's interval is narrow enough") {
  // All right: half of Wilson's interval is z²/(2(n + z²)): 0.0357 at 50, 0.0185 at 100.
  CHECK(stopped_after({Flags(400, 1)}, 0.036) == 50);
  CHECK(stopped_after({Flags(400, 1)}, 0.0356) == 100);
  CHECK(stopped_after({Flags(400, 0)}, 0.0184) == 150);
  // Half right: z √(1/(4n) + z²/(4n²)) / (1 + z²/n): 0.13355 at 50, 0.09617 at 100.
  CHECK(stopped_after({every_other(400)}, 0.0962) == 100);
  CHECK(stopped_after({every_other(400)}, 0.0961) == 150);
}

TEST_CASE("the widest interval of the methods decides") {
  CHECK(stopped_after({Flags(400, 1), every_other(400)}, 0.0962) == 100);
  CHECK(stopped_after({every_other(400), Flags(400, 1)}, 0.0962) == 100);
}

TEST_CASE("trials after the stop do not move it") {
  for (const std::size_t n : {50u, 51u, 99u, 1000u}) {
    Flags flags(50, 1);
    flags.resize(n, 0);
    CHECK(stopped_after({flags}, 0.036) == 50);
  }
  CHECK_FALSE(stopped_after({Flags(49, 1)}, 0.036));
}

TEST_CASE("a study that asks for no width never stops") {
  CHECK_FALSE(stopped_after({Flags(100000, 1)}, 0.0));
  CHECK_FALSE(stopped_after({}, 0.1));
  CHECK_FALSE(stopped_after({Flags{}}, 0.1));
  CHECK_FALSE(stopped_after({every_other(100)}, 0.01));
}
