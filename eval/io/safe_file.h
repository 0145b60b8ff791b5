#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "eval/io/interruption.h"

namespace honka::eval {

/// Throws the one line a user sees when the system refuses to write: what failed, on which path,
/// the system's reason and what to do. `error` is an errno value; always a UserError.
[[noreturn]] void throw_write_error(int error, const std::filesystem::path& path);

/// The text of a file. UserError when it is missing, a folder or unreadable.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

/// Writes a file so that its name never shows a part of it: temporary name in the same folder,
/// write, fsync, close, rename. Makes missing parent folders. UserError when it cannot be written.
void write_file_safely(const std::filesystem::path& path, std::string_view content);

/// A file that someone else (a library, a child process) writes under a temporary name.
///
/// Write to `temporary()`, close it, then `commit()`: fsync and rename to the final name. Without
/// commit the destructor removes the temporary file and the final name is untouched.
class StagedFile {
 public:
  explicit StagedFile(const std::filesystem::path& final_path);
  ~StagedFile();
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;

  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }
  void commit();

 private:
  std::filesystem::path final_, temporary_;
  Unfinished unfinished_;
  bool committed_ = false;
};

/// A folder of results that appears, or replaces an older one, as a whole.
///
/// Files go to `path()` = DIR.part-<pid>; `commit()` syncs and renames it over DIR. An existing DIR
/// is replaced only when it is empty or holds the file `marker`, so that a mistaken --out never
/// deletes a folder that is not ours (UserError at construction, before any work is done). Without
/// commit the destructor removes the staged folder; DIR keeps what it held.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& final_path,
                        const std::string& marker = "summary.json");
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return staged_; }
  [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }
  void commit();

 private:
  std::filesystem::path final_, staged_;
  Unfinished unfinished_;
  bool committed_ = false;
};

}  // namespace honka::eval
