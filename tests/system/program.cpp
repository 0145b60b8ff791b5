#include "tests/system/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace honka::test {
namespace fs = std::filesystem;
namespace {

void send_to(int stream, const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(126);
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  ::_exit(127);
}

bool tells_progress(const std::string& line) {
  static const std::regex kProgress(
      R"(.+: \d+ of \d+ (sweeps|key frames|windows|maps|pairs|rounds|lists|trials)\b.*)");
  return std::regex_match(line, kProgress);
}

}  // namespace

std::vector<std::string> Outcome::complaints() const {
  std::vector<std::string> lines;
  std::istringstream in(err);
  for (std::string line; std::getline(in, line);) {
    if (!tells_progress(line)) lines.push_back(line);
  }
  return lines;
}

Outcome run_honka(const std::vector<std::string>& arguments, const fs::path& folder,
                  const std::function<void(int child)>& meanwhile) {
  const std::string program = HONKA_BINARY_DIR "/honka";
  const TemporaryFolder streams;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    send_to(STDOUT_FILENO, streams / "out");
    send_to(STDERR_FILENO, streams / "err");
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    become(program, arguments);
  }
  if (meanwhile) meanwhile(child);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          read_text(streams / "out"), read_text(streams / "err")};
}

void check_refused(const Outcome& outcome, const std::vector<std::string>& parts) {
  INFO("stderr: " << outcome.err);
  CHECK(outcome.exit_code == 2);
  const auto complaints = outcome.complaints();
  REQUIRE(complaints.size() == 1);
  for (const std::string& part : parts) CHECK_THAT(complaints[0], Catch::Contains(part));
}

std::string tiny_scenario() {
  return R"(experiment = "localization"
title = "Tiny"
trials = 1
forest.width_m = 60.0
forest.length_m = 60.0
forest.crown.branches = false
forest.crown.foliage = false
forest.undergrowth.bushes_per_ha = 0.0
frame.distance_m = 2.0
map.strip_road_spacing_m = 30.0
protocol.frames = [1, 3]
protocol.path_length_m = 20.0
variants.tolerances_m2 = []
variants.repaired = false
)";
}

void write_tiny(const TemporaryFolder& folder, const std::string& name, const std::string& more) {
  write_raw(folder / name, tiny_scenario() + more);
}

std::vector<std::pair<std::string, std::string>> contents(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files.emplace_back(fs::relative(entry.path(), folder).string(), read_text(entry.path()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Json read_json(const fs::path& file) { return Json::parse(read_text(file)); }

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

fs::path shared(const std::string& path) {
  return fs::path(HONKA_SOURCE_DIR).parent_path() / "shared" / path;
}

}  // namespace honka::test
