#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "eval/study/trial_record.h"

namespace honka::eval {

/// The trials of a shard as they come, one line each, on disk as soon as they are known.
///
/// Whatever ends the process, all lines but one that was being written survive; that one is cut
/// off when the journal is opened again. One process at a time: the file is locked.
class Journal {
 public:
  /// Opens or makes the journal, and hands each record that it holds to `take`, in the order of
  /// writing. `title` is its first line: of what study and shard it is. UserError when another
  /// process has it open, when its title is another, or when lines before the last are damaged.
  Journal(std::filesystem::path path, const std::string& title,
          const std::function<void(TrialRecord)>& take);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// RunError when the system refuses (a full disk): the study can be resumed.
  void append(const TrialRecord& record);

  /// Removes the file, which the finished shard replaces.
  void remove();

 private:
  void open_locked();
  void read_lines(const std::string& title, const std::function<void(TrialRecord)>& take);
  void write_line(const std::string& line);

  std::filesystem::path path_;
  int file_ = -1;
};

/// Whether a process has the journal open.
[[nodiscard]] bool is_locked(const std::filesystem::path& journal);

/// The records of a journal that may be growing; what is cut short is left out.
[[nodiscard]] std::vector<TrialRecord> peek_journal(const std::filesystem::path& path);

}  // namespace honka::eval
