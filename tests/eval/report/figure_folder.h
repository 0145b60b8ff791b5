#pragma once

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "eval/io/safe_file.h"
#include "eval/report/report_model.h"

namespace honka::test {

/// RESULT/figures of its own that vanishes with the test; the environment variable
/// HONKA_TEST_FIGURES names a folder that keeps them, to be looked at.
class FigureFolder {
 public:
  FigureFolder() {
    static int count = 0;
    const char* kept = std::getenv("HONKA_TEST_FIGURES");
    keep_ = kept != nullptr;
    root_ =
        keep_ ? std::filesystem::path(kept)
              : std::filesystem::temp_directory_path() /
                    ("honka-figures-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path());
  }
  ~FigureFolder() {
    std::error_code ignored;
    if (!keep_) std::filesystem::remove_all(root_, ignored);
  }
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return root_ / "figures"; }
  [[nodiscard]] const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
  bool keep_ = false;
};

/// The picture exists, is no empty frame, and is drawn again, byte for byte, by its own script.
inline void check_drawn(const FigureFolder& folder, const eval::ReportFigure& figure,
                        const std::string& name, const std::string& extension) {
  INFO(name);
  CHECK(figure.notice.empty());
  CHECK(figure.file == "figures/" + name + "." + extension);
  CHECK_FALSE(figure.caption.empty());
  const auto picture = folder.root() / figure.file;
  REQUIRE(std::filesystem::exists(picture));
  const std::string bytes = eval::read_text_file(picture);
  CHECK(bytes.size() > 5000);
  CHECK(std::filesystem::exists(folder.path() / (name + ".dat")));
  CHECK_FALSE(std::filesystem::exists(folder.path() / (name + ".log")));
  std::filesystem::remove(picture);
  const std::string command =
      "cd '" + folder.path().string() + "' && gnuplot " + name + ".gp 2> /dev/null";
  CHECK(std::system(command.c_str()) == 0);
  CHECK(eval::read_text_file(picture) == bytes);
}

}  // namespace honka::test
