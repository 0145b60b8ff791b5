#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace honka {

/// Random numbers as a hash of identity: the same (seed, name, ids) gives the same numbers in
/// whatever order, on whatever thread they are drawn. Philox4x32-10 (Salmon et al. 2011).
class RandomStream {
 public:
  using result_type = std::uint32_t;

  /// The stream that belongs to `name` and `ids` (trial, scan, firing, channel, …).
  RandomStream(std::uint64_t seed, std::string_view name,
               std::initializer_list<std::uint64_t> ids = {});

  [[nodiscard]] std::uint32_t bits32();
  [[nodiscard]] std::uint64_t bits64();
  /// In [0, 1), 53 bits.
  [[nodiscard]] double uniform();
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, n).
  [[nodiscard]] std::uint64_t below(std::uint64_t n);
  /// Standard normal, by Box–Muller.
  [[nodiscard]] double normal();
  [[nodiscard]] double normal(double mean, double sd) { return mean + sd * normal(); }
  [[nodiscard]] double weibull(double shape, double scale);
  /// Knuth's product below 30, a rounded normal above.
  [[nodiscard]] int poisson(double mean);

 private:
  void refill();

  std::array<std::uint32_t, 2> key_;
  std::uint64_t counter_ = 0;
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

/// A seed derived from another, for a part that hands out streams of its own.
[[nodiscard]] std::uint64_t derive_seed(std::uint64_t seed, std::string_view name,
                                        std::initializer_list<std::uint64_t> ids = {});

/// 64-bit hash of a name; constant over platforms (FNV-1a).
[[nodiscard]] constexpr std::uint64_t hash_name(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

/// One round of mixing (SplitMix64's finalizer, Steele et al. 2014).
[[nodiscard]] constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace honka
