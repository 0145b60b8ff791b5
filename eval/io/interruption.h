#pragma once

#include <filesystem>

namespace honka::eval {

/// From here on Ctrl-C and SIGTERM end the program cleanly: what is unfinished on disk is removed,
/// one line says so, and the exit code is 3. Call once, before any other thread starts.
void end_cleanly_when_interrupted();

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
