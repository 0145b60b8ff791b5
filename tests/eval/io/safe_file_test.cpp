#include "eval/io/safe_file.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>

#include "tests/eval/io/temporary_folder.h"

using namespace honka::eval;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
using honka::test::write_raw;

TEST_CASE("safe file: writes, replaces, makes parents, leaves nothing else") {
  const TemporaryFolder folder;
  write_file_safely(folder / "a.txt", "one");
  write_file_safely(folder / "a.txt", "two\n");
  CHECK(read_text_file(folder / "a.txt") == "two\n");
  write_file_safely(folder / "deep/er/b.txt", "");
  CHECK(read_text_file(folder / "deep/er/b.txt").empty());
  CHECK(folder.entries() == 2);
}

TEST_CASE("safe file: a path that cannot be written gives one line and leaves nothing") {
  const TemporaryFolder folder;
  write_raw(folder / "file", "kept");
  const std::string below = (folder / "file/x/out.txt").string();
  const std::string line = user_error_of([&] { write_file_safely(below, "text"); });
  CHECK(line.find("cannot be written (Not a directory)") != std::string::npos);
  CHECK(line.find('\n') == std::string::npos);
  CHECK(read_text_file(folder / "file") == "kept");
  CHECK(user_error_of([&] { write_file_safely(folder.path(), "text"); }).find("Is a directory") !=
        std::string::npos);
  CHECK_THROWS_AS(OutputFolder("/proc/honka/results"), honka::UserError);
  CHECK(folder.entries() == 1);
}

TEST_CASE("safe file: a full disk gives one line that says so") {
  const std::string line =
      user_error_of([] { write_file_safely("/dev/full", std::string(100000, 'x')); });
  CHECK(line ==
        "/dev/full: cannot be written (No space left on device); free some space or give --out a "
        "folder on another disk");
}

TEST_CASE("safe file: a write that stops halfway keeps the old content and no leftovers") {
  const TemporaryFolder folder;
  write_file_safely(folder / "a.txt", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    // A limit of 1,000 bytes a file stands for a disk that fills up in the middle of a write.
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file_safely(folder / "a.txt", std::string(5000, 'x'));
    } catch (const honka::UserError&) {
      ::_exit(2);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(read_text_file(folder / "a.txt") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("staged file: kill -9 before the commit leaves the old file whole") {
  const TemporaryFolder folder;
  write_file_safely(folder / "a.txt", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    StagedFile staged(folder / "a.txt");
    write_raw(staged.temporary(), "half a fi");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  CHECK(read_text_file(folder / "a.txt") == "old");
}

TEST_CASE("output folder: appears at the commit, replaces as a whole, cleans up without") {
  const TemporaryFolder folder;
  {
    OutputFolder out(folder / "run/");
    write_raw(out.path() / "summary.json", "1");
    write_raw(out.path() / "old.txt", "1");
    CHECK_FALSE(std::filesystem::exists(folder / "run"));
    out.commit();
  }
  {
    OutputFolder out(folder / "run");
    write_raw(out.path() / "summary.json", "2");
    std::filesystem::create_directories(out.path() / "figures");
    write_raw(out.path() / "figures/a.svg", "<svg/>");
    CHECK(read_text_file(folder / "run/summary.json") == "1");
    out.commit();
  }
  CHECK(read_text_file(folder / "run/summary.json") == "2");
  CHECK_FALSE(std::filesystem::exists(folder / "run/old.txt"));
  CHECK(std::filesystem::exists(folder / "run/figures/a.svg"));
  { OutputFolder dropped(folder / "run"); }
  CHECK(read_text_file(folder / "run/summary.json") == "2");
  CHECK(folder.entries() == 1);
}

TEST_CASE("output folder: a folder that is not ours is never replaced") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "thesis");
  write_raw(folder / "thesis/chapter1.tex", "precious");
  const std::string line = user_error_of([&] { OutputFolder out(folder / "thesis"); });
  CHECK(line == (folder / "thesis").string() +
                    ": exists and holds no summary.json, so it is not replaced; give --out another "
                    "name or empty the folder");
  CHECK(read_text_file(folder / "thesis/chapter1.tex") == "precious");
  CHECK(folder.entries() == 1);
}
