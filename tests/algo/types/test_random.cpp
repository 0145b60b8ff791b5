#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "algo/types/random.h"

using namespace honka;

namespace {

/// Philox4x32-10 as Salmon et al. 2011 define it, written out.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = 0xD2511F53ULL * c[0];
    const std::uint64_t b = 0xCD9E8D57ULL * c[2];
    c = {static_cast<std::uint32_t>(b >> 32U) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32U) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9U;
    key[1] += 0xBB67AE85U;
  }
  return c;
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

template <typename Draw>
Moments moments(int n, Draw draw) {
  std::vector<double> values(static_cast<std::size_t>(n));
  for (double& v : values) v = draw();
  Moments m;
  for (const double v : values) m.mean += v / n;
  for (const double v : values) m.variance += (v - m.mean) * (v - m.mean) / n;
  return m;
}

}  // namespace

TEST_CASE("the published answers of Philox4x32-10") {
  using Block = std::array<std::uint32_t, 4>;
  CHECK(philox({0, 0, 0, 0}, {0, 0}) == Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  CHECK(philox({~0U, ~0U, ~0U, ~0U}, {~0U, ~0U}) ==
        Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("a stream is Philox under the key of its identity") {
  const std::uint64_t key = derive_seed(42, "range_noise", {7, 8, 9});
  RandomStream stream(42, "range_noise", {7, 8, 9});
  for (std::uint32_t counter = 0; counter < 5; ++counter) {
    const auto block = philox({counter, 0, 0, 0}, {static_cast<std::uint32_t>(key),
                                                   static_cast<std::uint32_t>(key >> 32U)});
    for (const std::uint32_t word : block) CHECK(stream.bits32() == word);
  }
}

TEST_CASE("hashes: FNV-1a and the finalizer of SplitMix64") {
  CHECK(hash_name("") == 0xcbf29ce484222325ULL);
  CHECK(hash_name("a") == 0xaf63dc4c8601ec8cULL);
  CHECK(hash_name("foobar") == 0x85944171f73967e8ULL);
  CHECK(mix64(0) == 0xe220a8397b1dcdafULL);
}

TEST_CASE("identity decides: seed, name, ids and their order") {
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {0ULL, 1ULL, ~0ULL}) {
    for (const char* name : {"a", "b", "ab"}) {
      first.insert(RandomStream(seed, name).bits64());
      first.insert(RandomStream(seed, name, {0}).bits64());
      first.insert(RandomStream(seed, name, {0, 0}).bits64());
      first.insert(RandomStream(seed, name, {0, 1}).bits64());
      first.insert(RandomStream(seed, name, {1, 0}).bits64());
    }
  }
  CHECK(first.size() == 3 * 3 * 5);
  CHECK(RandomStream(5, "x", {1}).bits64() == RandomStream(5, "x", {1}).bits64());
}

TEST_CASE("neighbouring streams are not correlated") {
  constexpr int kN = 20000;
  double sum = 0.0;
  for (int i = 0; i < kN; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    sum += RandomStream(1, "pair", {id}).normal() * RandomStream(1, "pair", {id + 1}).normal();
  }
  CHECK(std::abs(sum / kN) < 4.0 / std::sqrt(double(kN)));
}

TEST_CASE("uniform numbers: range, moments and even spread") {
  RandomStream stream(1, "uniform_test");
  std::array<int, 16> bins{};
  constexpr int kN = 160000;
  const Moments m = moments(kN, [&] {
    const double u = stream.uniform();
    CHECK((u >= 0.0 && u < 1.0));
    ++bins[static_cast<std::size_t>(u * 16.0)];
    return u;
  });
  CHECK(m.mean == Approx(0.5).margin(4.0 * std::sqrt(1.0 / 12.0 / kN)));
  CHECK(m.variance == Approx(1.0 / 12.0).epsilon(0.02));
  double chi2 = 0.0;
  for (const int count : bins) chi2 += std::pow(count - kN / 16.0, 2) / (kN / 16.0);
  CHECK(chi2 < 37.7);  // 0.1 % point of 15 degrees of freedom
}

TEST_CASE("normal numbers: four moments and the tails") {
  RandomStream stream(1, "normal_test");
  constexpr int kN = 100000;
  double third = 0.0;
  double fourth = 0.0;
  int beyond = 0;
  const Moments m = moments(kN, [&] {
    const double z = stream.normal();
    third += z * z * z / kN;
    fourth += z * z * z * z / kN;
    beyond += std::abs(z) > 1.959964 ? 1 : 0;
    return z;
  });
  CHECK(m.mean == Approx(0.0).margin(4.0 / std::sqrt(double(kN))));
  CHECK(m.variance == Approx(1.0).epsilon(0.02));
  CHECK(third == Approx(0.0).margin(4.0 * std::sqrt(15.0 / kN)));
  CHECK(fourth == Approx(3.0).margin(4.0 * std::sqrt(96.0 / kN)));
  CHECK(beyond == Approx(0.05 * kN).margin(4.0 * std::sqrt(0.05 * 0.95 * kN)));
  RandomStream scaled(1, "normal_scaled");
  const Moments s = moments(kN, [&] { return scaled.normal(10.0, 3.0); });
  CHECK(s.mean == Approx(10.0).margin(0.04));
  CHECK(s.variance == Approx(9.0).epsilon(0.02));
}

TEST_CASE("normal numbers come in pairs of Box and Muller") {
  RandomStream stream(3, "box_muller");
  RandomStream twin(3, "box_muller");
  for (int pair = 0; pair < 3; ++pair) {
    const double radius = std::sqrt(-2.0 * std::log1p(-twin.uniform()));
    const double angle = 2.0 * std::acos(-1.0) * twin.uniform();
    CHECK(stream.normal() == Approx(radius * std::cos(angle)));
    CHECK(stream.normal() == Approx(radius * std::sin(angle)));
  }
}

TEST_CASE("Weibull numbers have the mean and variance of their law") {
  const double shape = GENERATE(1.0, 2.0, 3.6);
  RandomStream stream(1, "weibull_test");
  const double scale = 18.0;
  const Moments m = moments(100000, [&] { return stream.weibull(shape, scale); });
  const double mean = scale * std::tgamma(1.0 + 1.0 / shape);
  CHECK(m.mean == Approx(mean).epsilon(0.015));
  CHECK(m.variance ==
        Approx(scale * scale * std::tgamma(1.0 + 2.0 / shape) - mean * mean).epsilon(0.04));
}

TEST_CASE("Poisson numbers have equal mean and variance, on both sides of the switch") {
  const double mean = GENERATE(0.0, 0.1, 3.0, 29.9, 30.0, 400.0);
  RandomStream stream(1, "poisson_test");
  int zeros = 0;
  const Moments m = moments(50000, [&] {
    const int count = stream.poisson(mean);
    CHECK(count >= 0);
    zeros += count == 0 ? 1 : 0;
    return static_cast<double>(count);
  });
  CHECK(m.mean == Approx(mean).margin(4.0 * std::sqrt(mean / 50000.0)));
  CHECK(m.variance == Approx(mean).epsilon(0.05));
  const double none = std::exp(-mean);
  CHECK(zeros == Approx(50000.0 * none).margin(4.0 * std::sqrt(50000.0 * none * (1.0 - none))));
}

TEST_CASE("below(n) covers 0 … n − 1 evenly") {
  RandomStream stream(1, "below_test");
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(stream.below(7));
  for (const int count : counts) CHECK(count == Approx(10000).margin(400));
  CHECK(stream.below(1) == 0);
}
