#include "eval/io/safe_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "algo/types/user_error.h"

namespace honka::eval {
namespace fs = std::filesystem;
namespace {

/// A file descriptor that closes itself; close() reports what a late write error was.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : path_(path), fd_(::open(path.c_str(), flags, 0644)) {
    if (fd_ < 0) throw_write_error(errno, path);
  }
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write_all(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = ::write(fd_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw_write_error(errno, path_);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void sync_and_close() {
    // EINVAL: a folder or special file that cannot be synced has nothing to lose.
    if (::fsync(fd_) != 0 && errno != EINVAL) throw_write_error(errno, path_);
    const int fd = fd_;
    fd_ = -1;
    if (::close(fd) != 0) throw_write_error(errno, path_);
  }

 private:
  fs::path path_;
  int fd_;
};

fs::path without_trailing_slash(const fs::path& path) {
  const fs::path clean = path.lexically_normal();
  return clean.has_filename() ? clean : clean.parent_path();
}

fs::path parent_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_write_error(error.value(), folder);
  if (!fs::is_directory(folder)) throw_write_error(ENOTDIR, folder);
}

void sync_path(const fs::path& path, int flags) { Descriptor(path, flags).sync_and_close(); }

void rename_or_throw(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) throw_write_error(errno, to);
}

std::string part_suffix() { return ".part-" + std::to_string(::getpid()); }

/// Puts `from` in place of the existing folder `to` and leaves the old one at `from`, so that the
/// name `to` is never absent; file systems that cannot exchange get two renames.
void exchange_folders(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  const fs::path old = to.string() + ".old-" + std::to_string(::getpid());
  rename_or_throw(to, old);
  rename_or_throw(from, to);
  rename_or_throw(old, from);
}

void check_replaceable(const fs::path& folder, const std::string& marker) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) {
    throw UserError(folder.string() + ": is a file, not a folder; give --out the name of a folder");
  }
  if (fs::is_empty(folder) || fs::exists(folder / marker)) return;
  throw UserError(folder.string() + ": exists and holds no " + marker +
                  ", so it is not replaced; give --out another name or empty the folder");
}

}  // namespace

void throw_write_error(int error, const fs::path& path) {
  std::string remedy = "check that the folder exists and may be written to";
  if (error == ENOSPC || error == EDQUOT) {
    remedy = "free some space or give --out a folder on another disk";
  } else if (error == EISDIR) {
    remedy = "give the name of a file";
  } else if (error == ENOTDIR || error == EEXIST) {
    remedy = "a part of this path is a file; give another folder";
  }
  throw UserError(path.string() + ": cannot be written (" + std::strerror(error) + "); " + remedy);
}

std::string read_text_file(const fs::path& path) {
  if (!fs::exists(path)) throw UserError(path.string() + ": no such file; check the path");
  if (fs::is_directory(path)) {
    throw UserError(path.string() + ": is a folder; give the name of a file");
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || (text.fail() && fs::file_size(path) > 0)) {
    throw UserError(path.string() + ": cannot be read; check its permissions");
  }
  return std::move(text).str();
}

void write_file_safely(const fs::path& path, std::string_view content) {
  if (fs::exists(path) && !fs::is_regular_file(path) && !fs::is_directory(path)) {
    Descriptor device(path, O_WRONLY | O_CLOEXEC);  // a pipe or device has no half-written name
    device.write_all(content);
    device.sync_and_close();
    return;
  }
  StagedFile staged(path);
  Descriptor file(staged.temporary(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
  file.write_all(content);
  file.sync_and_close();
  staged.commit();
}

StagedFile::StagedFile(const fs::path& final_path)
    : final_(fs::is_symlink(final_path) ? fs::weakly_canonical(final_path) : final_path),
      temporary_(final_.string() + part_suffix()),
      unfinished_(temporary_) {
  if (fs::is_directory(final_)) throw_write_error(EISDIR, final_);
  make_folder(parent_of(final_));
}

StagedFile::~StagedFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void StagedFile::commit() {
  sync_path(temporary_, O_RDONLY | O_CLOEXEC);
  rename_or_throw(temporary_, final_);
  committed_ = true;
  sync_path(parent_of(final_), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

OutputFolder::OutputFolder(const fs::path& final_path, const std::string& marker)
    : final_(without_trailing_slash(final_path)),
      staged_(final_.string() + part_suffix()),
      unfinished_(staged_) {
  check_replaceable(final_, marker);
  make_folder(parent_of(final_));
  std::error_code ignored;
  fs::remove_all(staged_, ignored);
  make_folder(staged_);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(staged_, ignored);
}

void OutputFolder::commit() {
  for (const auto& entry : fs::recursive_directory_iterator(staged_)) {
    if (entry.is_regular_file()) sync_path(entry.path(), O_RDONLY | O_CLOEXEC);
  }
  sync_path(staged_, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  std::error_code ignored;
  if (fs::exists(final_)) {
    exchange_folders(staged_, final_);
    committed_ = true;
    fs::remove_all(staged_, ignored);
  } else {
    rename_or_throw(staged_, final_);
    committed_ = true;
  }
  sync_path(parent_of(final_), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

}  // namespace honka::eval
