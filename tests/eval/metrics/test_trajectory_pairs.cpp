#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "eval/metrics/trajectory_pairs.h"

using namespace honka;
using namespace honka::eval;

namespace {

using Times = std::vector<double>;
using Pairs = std::vector<TimePair>;

Times random_times(std::uint64_t id, std::size_t n) {
  RandomStream random(1, "times", {id});
  Times times;
  double time_s = random.uniform();
  for (std::size_t i = 0; i < n; ++i) times.push_back(time_s += random.uniform(0.01, 0.2));
  return times;
}

}  // namespace

TEST_CASE("times pair with the nearest, within the limit and on it") {
  CHECK(associate_times(Times{0, 1, 2, 3}, Times{0.9, 2.25, 9}, 0.25) == Pairs{{1, 0}, {2, 1}});
  CHECK(associate_times(Times{0, 1}, Times{0, 1, 2}, 0.0) == Pairs{{0, 0}, {1, 1}});
  CHECK(associate_times(Times{0, 2}, Times{1}, 1.0) == Pairs{{0, 0}});
  CHECK(associate_times(Times{}, Times{1}, 1.0).empty());
  CHECK(associate_times(Times{1}, Times{}, 1.0).empty());
}

TEST_CASE("two claims to a time: the nearer wins, the earlier of equals") {
  CHECK(associate_times(Times{0, 5, 10}, Times{4.8, 5.1}, 0.5) == Pairs{{1, 1}});
  CHECK(associate_times(Times{0, 5, 10}, Times{4.75, 5.25}, 0.5) == Pairs{{1, 0}});
  CHECK(associate_times(Times{4.8, 5.1}, Times{0, 5, 10}, 0.5) == Pairs{{1, 1}});
}

TEST_CASE("association is one to one, in order, and the same from either side") {
  for (std::uint64_t id = 0; id < 20; ++id) {
    const Times a = random_times(2 * id, 40), b = random_times(2 * id + 1, 60);
    const double limit_s = 0.02 + 0.01 * static_cast<double>(id);
    const Pairs forth = associate_times(a, b, limit_s);
    Pairs back = associate_times(b, a, limit_s);
    for (TimePair& pair : back) std::swap(pair.truth, pair.estimate);
    CHECK(forth == back);
    for (std::size_t i = 0; i < forth.size(); ++i) {
      CHECK(std::abs(a[forth[i].truth] - b[forth[i].estimate]) <= limit_s);
      if (i == 0) continue;
      CHECK(forth[i - 1].truth < forth[i].truth);
      CHECK(forth[i - 1].estimate < forth[i].estimate);
    }
  }
}

TEST_CASE("the nearest time by search is the nearest of all") {
  const Times times = random_times(99, 50);
  for (double t = -1.0; t < times.back() + 1.0; t += 0.013) {
    const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
      return std::abs(a - t) < std::abs(b - t);
    });
    CHECK(times[nearest_time(times, t)] == *nearest);
  }
}
