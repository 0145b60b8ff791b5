#include "algo/types/random.h"

#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/check.h"
#include "algo/types/philox.h"

namespace honka {

std::uint64_t derive_seed(std::uint64_t seed, std::string_view name,
                          std::initializer_list<std::uint64_t> ids) {
  std::uint64_t hash = mix64(seed ^ mix64(hash_name(name)));
  for (const std::uint64_t id : ids) {
    hash = mix64(hash ^ mix64(id));
  }
  return hash;
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name,
                           std::initializer_list<std::uint64_t> ids) {
  const std::uint64_t key = derive_seed(seed, name, ids);
  key_ = {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U)};
}

void RandomStream::refill() {
  block_ = philox_block(key_, {static_cast<std::uint32_t>(counter_),
                               static_cast<std::uint32_t>(counter_ >> 32U), 0, 0});
  ++counter_;
  used_ = 0;
}

std::uint32_t RandomStream::bits32() {
  if (used_ == 4) refill();
  return block_[static_cast<std::size_t>(used_++)];
}

std::uint64_t RandomStream::bits64() {
  const std::uint64_t low = bits32();
  return low | (static_cast<std::uint64_t>(bits32()) << 32U);
}

double RandomStream::uniform() { return static_cast<double>(bits64() >> 11U) * 0x1.0p-53; }

std::uint64_t RandomStream::below(std::uint64_t n) {
  HONKA_CHECK(n > 0, "a number below nothing");
  // Multiply and shift; the bias is below n / 2^64.
  return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits64()) * n) >> 64U);
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log1p(-uniform()));
  const double angle = 2.0 * kPi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

double RandomStream::weibull(double shape, double scale) {
  return scale * std::pow(-std::log1p(-uniform()), 1.0 / shape);
}

int RandomStream::poisson(double mean) {
  HONKA_CHECK(mean >= 0.0, "the mean of a Poisson law is negative");
  if (mean >= 30.0) {
    return std::max(0, static_cast<int>(std::lround(normal(mean, std::sqrt(mean)))));
  }
  const double limit = std::exp(-mean);
  int count = 0;
  for (double product = uniform(); product > limit; product *= uniform()) ++count;
  return count;
}

}  // namespace honka
