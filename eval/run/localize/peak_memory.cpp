#include "eval/run/localize/peak_memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace honka::eval {
namespace {

/// A line such as "VmHWM:   1234 kB" of the kernel's account of this process.
std::optional<std::int64_t> status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key + ":", 0) != 0) continue;
    std::istringstream words(line.substr(key.size() + 1));
    std::int64_t kibibytes = 0;
    if (words >> kibibytes) return 1024 * kibibytes;
  }
  return std::nullopt;
}

}  // namespace

MemoryMeter::MemoryMeter() {
  malloc_trim(0);  // what was freed before is not there to be used again unseen
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins anew
  at_start_ = status_bytes("VmRSS");
}

std::optional<std::int64_t> MemoryMeter::peak_bytes() const {
  const auto peak = status_bytes("VmHWM");
  if (!peak || !at_start_) return std::nullopt;
  return std::max<std::int64_t>(0, *peak - *at_start_);
}

}  // namespace honka::eval
