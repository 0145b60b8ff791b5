#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <functional>

#include "tests/architecture/rules.h"

namespace honka::architecture {
namespace fs = std::filesystem;
namespace {

/// A tree with one planted file, removed at the end.
class PlantedTree {
 public:
  PlantedTree(const std::string& file, const std::string& text)
      : root_(fs::temp_directory_path() /
              ("honka_planted_" + std::to_string(::getpid()) + "_" + std::to_string(count_++))) {
    fs::remove_all(root_);
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  ~PlantedTree() { fs::remove_all(root_); }
  PlantedTree(const PlantedTree&) = delete;
  PlantedTree& operator=(const PlantedTree&) = delete;
  [[nodiscard]] const fs::path& root() const { return root_; }

 private:
  static inline int count_ = 0;
  fs::path root_;
};

void require_clean(const Violations& violations) {
  for (const std::string& violation : violations) UNSCOPED_INFO(violation);
  REQUIRE(violations.empty());
}

}  // namespace

TEST_CASE("The house keeps its rules") {
  const fs::path root = HONKA_SOURCE_DIR;
  SECTION("includes follow the direction of dependencies") { require_clean(wrong_includes(root)); }
  SECTION("only eval/cli has a main") { require_clean(wrong_mains(root)); }
  SECTION("no machine paths and left-over markers") { require_clean(wrong_words(root)); }
  SECTION("no file is longer than 300 lines") { require_clean(long_files(root)); }
  SECTION("the top level is the plan's") { require_clean(strange_top_level(root)); }
  SECTION("every cited equation is in the index") { require_clean(unindexed_equations(root)); }
}

TEST_CASE("A planted wrong include is found") {
  const auto [file, include] = GENERATE(table<std::string, std::string>({
      {"algo/stems/x.cpp", "\"sim/world/world.h\""},
      {"algo/types/x.h", "\"algo/stems/extract.h\""},
      {"algo/stems/x.cpp", "<CGAL/Delaunay_triangulation_2.h>"},
      {"algo/localize/x.cpp", "<nanoflann.hpp>"},
      {"sim/forest/x.cpp", "\"algo/stems/extract.h\""},
      {"sim/forest/x.cpp", "<embree3/rtcore.h>"},
      {"sim/lidar/x.h", "\"eval/io/csv.h\""},
      {"eval/metrics/x.cpp", "\"eval/io/csv.h\""},
      {"eval/run/x.cpp", "\"eval/cli/verbs.h\""},
      {"eval/run/x.cpp", "<hdf5.h>"},
  }));
  const PlantedTree tree(file, "#pragma once\n#include " + include + "\n");
  const Violations violations = wrong_includes(tree.root());
  REQUIRE(violations.size() == 1);
  REQUIRE_THAT(violations[0], Catch::StartsWith(file + ":2: "));
}

TEST_CASE("Other planted faults are found") {
  using Rule = std::function<Violations(const fs::path&)>;
  const auto [rule, file, text] = GENERATE(table<Rule, std::string, std::string>({
      {wrong_mains, "sim/lidar/x.cpp", "int main() {}\n"},
      {wrong_words, "algo/stems/x.cpp", std::string("// TO") + "DO later\n"},
      {wrong_words, "eval/io/x.cpp", std::string("open(\"/wo") + "rk/file\");\n"},
      {long_files, "algo/stems/x.cpp", std::string(301, '\n')},
      {strange_top_level, "notes/x.txt", "remember\n"},
      {unindexed_equations, "algo/slam/x.cpp", "// Nevalainen2021 Eq. (19)\n"},
  }));
  const PlantedTree tree(file, text);
  REQUIRE(rule(tree.root()).size() == 1);
}

TEST_CASE("What the plan allows passes") {
  const PlantedTree tree(
      "eval/run/x.cpp",
      "#include <vector>\n#include \"sim/world/world.h\"\n#include <Eigen/Core>\n");
  REQUIRE(wrong_includes(tree.root()).empty());
  REQUIRE(wrong_words(tree.root()).empty());
}

}  // namespace honka::architecture
