#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace honka::eval {

inline constexpr std::int64_t kResultsSchemaVersion = 1;

/// Under which circumstances a result came about; stands at the head of each output.
///
/// Make it when the run starts; `entries()` at its end adds the wall time.
class Context {
 public:
  /// `isa`: instruction set that the ray caster was asked for.
  Context(int threads, std::int64_t seed, std::string isa = "avx2");

  /// schema_version, version, commit, dirty, compiler, build_type, host, cpu, isa, threads, seed,
  /// start_time (UTC, ISO 8601), wall_time_s.
  [[nodiscard]] std::map<std::string, std::string> entries() const;

 private:
  int threads_;
  std::int64_t seed_;
  std::string isa_;
  std::chrono::system_clock::time_point start_;
  std::chrono::steady_clock::time_point steady_start_;
};

}  // namespace honka::eval
