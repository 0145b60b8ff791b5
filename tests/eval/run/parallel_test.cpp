#include "eval/run/parallel.h"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "eval/run/thread_count.h"

using namespace honka::eval;

TEST_CASE("every index is worked on once, by any number of threads") {
  const int threads = GENERATE(1, 2, 7);
  const std::size_t count = GENERATE(0, 1, 1000);
  std::vector<int> calls(count, 0);
  for_each_index(count, threads, [&](std::size_t i) { ++calls[i]; });
  CHECK(calls == std::vector<int>(count, 1));
}

TEST_CASE("of several failures the one of the least index comes out, by any number of threads") {
  const int threads = GENERATE(1, 2, 7);
  for (int repeat = 0; repeat < 50; ++repeat) {
    try {
      for_each_index(100, threads, [](std::size_t i) {
        if (i % 10 == 3) throw std::runtime_error(std::to_string(i));
      });
      FAIL("nothing was thrown");
    } catch (const std::runtime_error& error) {
      REQUIRE(std::string(error.what()) == "3");
    }
  }
}

TEST_CASE("threads: as asked, or one a core") {
  CHECK(thread_count(3) == 3);
  CHECK(thread_count(0) >= 1);
  CHECK(thread_count(-2) == thread_count(0));
}
