#include "eval/study/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannot_write(const fs::path& path, int error) {
  throw RunError(fmt::format(
      "{}: cannot be written: {}; every finished trial is kept: mend that and give the same "
      "command to go on",
      path.string(), std::strerror(error)));
}

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Calls `take` for each whole line; returns how many bytes these have.
std::size_t each_line(const std::string& text,
                      const std::function<void(std::size_t, std::string_view)>& take) {
  std::size_t begin = 0, number = 1;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    take(number++, std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return begin;
}

}  // namespace

Journal::Journal(fs::path path, const std::string& title,
                 const std::function<void(TrialRecord)>& take)
    : path_(std::move(path)) {
  open_locked();
  try {
    read_lines(title, take);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() { ::close(file_); }

void Journal::open_locked() {
  constexpr int kMode = 0644;
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kMode);
  if (file_ < 0) throw_write_error(errno, path_);
  // Of the open file, not of the process: two that one process opens exclude each other too.
  struct flock whole = whole_file();
  if (::fcntl(file_, F_OFD_SETLK, &whole) == 0) return;
  ::close(file_);
  throw UserError(fmt::format(
      "{}: another process works on this shard; wait for it, or give another --out or --shard",
      path_.string()));
}

void Journal::read_lines(const std::string& title, const std::function<void(TrialRecord)>& take) {
  const std::string text = read_text_file(path_);
  const std::size_t whole = each_line(text, [&](std::size_t number, std::string_view line) {
    if (number == 1) {
      if (line == title) return;
      throw UserError(fmt::format(
          "{}:1: belongs to another study or another version of honka; give another --out",
          path_.string()));
    }
    std::optional<TrialRecord> record = from_line(line);
    if (!record) {
      throw UserError(fmt::format(
          "{}:{}: damaged; delete the lines from here on, and give the same command to run these "
          "trials again",
          path_.string(), number));
    }
    take(std::move(*record));
  });
  if (whole < text.size() && ::ftruncate(file_, static_cast<off_t>(whole)) != 0) {
    cannot_write(path_, errno);
  }
  if (whole == 0) write_line(title);
}

void Journal::write_line(const std::string& line) {
  const std::string text = line + "\n";
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file_, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) cannot_write(path_, errno);
    done += static_cast<std::size_t>(wrote);
  }
}

void Journal::append(const TrialRecord& record) { write_line(to_line(record)); }

void Journal::remove() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

bool is_locked(const fs::path& journal) {
  const int file = ::open(journal.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct flock whole = whole_file();
  const bool told = ::fcntl(file, F_OFD_GETLK, &whole) == 0;
  ::close(file);
  return told && whole.l_type != F_UNLCK;
}

std::vector<TrialRecord> peek_journal(const fs::path& path) {
  std::vector<TrialRecord> records;
  each_line(read_text_file(path), [&](std::size_t, std::string_view line) {
    if (auto record = from_line(line)) records.push_back(std::move(*record));
  });
  return records;
}

}  // namespace honka::eval
