#pragma once

#include <filesystem>
#include <string>

namespace honka::eval {

/// From here on Ctrl-C and SIGTERM end the program cleanly: what is unfinished on disk is removed,
/// one line says so, and the exit code is 3. Call once, before any other thread starts.
void end_cleanly_when_interrupted();

/// What the line says after which signal it was, in place of "earlier results are untouched …":
/// for work that is kept and can be gone on with.
void when_interrupted_say(const std::string& advice);

/// A file or folder that must not outlive an interrupted program, for as long as this object lives.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::filesystem::path path_;
};

}  // namespace honka::eval
