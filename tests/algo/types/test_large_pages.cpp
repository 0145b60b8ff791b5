// Lists in large pages are lists like any other.
#include <catch2/catch.hpp>
#include <cstdint>
#include <numeric>

#include "algo/types/large_pages.h"

TEST_CASE("A list in large pages holds what is put in, whatever its size") {
  for (const std::size_t count : {std::size_t{0}, std::size_t{3}, std::size_t{2'000'000}}) {
    std::vector<std::uint32_t> list;
    honka::reserve_in_large_pages(list, count);
    REQUIRE(list.capacity() >= count);
    REQUIRE(list.empty());
    list.resize(count);
    std::iota(list.begin(), list.end(), 1U);
    CHECK(std::accumulate(list.begin(), list.end(), std::uint64_t{0}) == count * (count + 1) / 2);
  }
}
