#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eval/study/subject.h"

namespace honka::eval {

/// How a trial ended. All but the first are failed trials: rows with a cause, never missing rows.
enum class TrialStatus { kDone, kThrew, kTimedOut, kOutOfMemory, kCrashed };

/// "done", "threw", "timed_out", "out_of_memory", "crashed".
[[nodiscard]] std::string_view name_of(TrialStatus status);

/// Which trial of a study.
struct TrialId {
  std::int64_t point = 0, trial = 0;

  auto operator<=>(const TrialId&) const = default;
};

/// Of the column `resident_mb`.
inline constexpr double kBytesPerMegabyte = 1e6;

/// One trial as it came out; what it cost is not part of the digest.
struct TrialRecord {
  TrialId id;
  TrialStatus status = TrialStatus::kDone;
  std::string cause;                  ///< one line; empty when done
  std::vector<MethodResult> results;  ///< one a method; empty when it failed
  double wall_s = 0.0, cpu_s = 0.0;
  std::int64_t resident_bytes = 0;  ///< of the worker, when the trial ended

  bool operator==(const TrialRecord&) const = default;
};

/// A record as one line of text without its end: a checksum first, doubles with all their digits.
[[nodiscard]] std::string to_line(const TrialRecord& record);

/// Nothing where the line is cut short or was changed.
[[nodiscard]] std::optional<TrialRecord> from_line(std::string_view line);

}  // namespace honka::eval
