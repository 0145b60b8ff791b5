#include "eval/io/context.h"

#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>

#include "eval/io/build_info.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

}  // namespace

Context::Context(int threads, std::int64_t seed, std::string isa)
    : threads_(threads),
      seed_(seed),
      isa_(std::move(isa)),
      start_(std::chrono::system_clock::now()),
      steady_start_(std::chrono::steady_clock::now()) {}

std::map<std::string, std::string> Context::entries() const {
  const BuildInfo build = build_info();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - steady_start_;
  return {{"schema_version", std::to_string(kResultsSchemaVersion)},
          {"version", build.version},
          {"commit", build.commit},
          {"dirty", build.dirty ? "true" : "false"},
          {"compiler", build.compiler},
          {"build_type", build.build_type},
          {"host", host_name()},
          {"cpu", cpu_name()},
          {"isa", isa_},
          {"threads", std::to_string(threads_)},
          {"seed", std::to_string(seed_)},
          {"start_time", utc_text(start_)},
          {"wall_time_s", exact_text(wall.count())}};
}

}  // namespace honka::eval
