#include "tests/architecture/rules.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>

namespace honka::architecture {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> sources(const fs::path& root, const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void for_each_line(const fs::path& file,
                   const std::function<void(int, const std::string&)>& visit) {
  std::ifstream stream(file);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) visit(number, line);
}

std::string located(const fs::path& root, const fs::path& file, int line, const std::string& what) {
  return fs::relative(file, root).string() + ":" + std::to_string(line) + ": " + what;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

/// Folder (longest match counts) -> beginnings of project includes that it may hold.
const std::map<std::string, std::vector<std::string>>& allowed_includes() {
  static const std::map<std::string, std::vector<std::string>> kAllowed = {
      {"algo/types", {"algo/types/"}},
      {"algo/geometry", {"algo/types/", "algo/geometry/"}},
      {"algo", {"algo/"}},
      {"sim/world", {"algo/types/", "sim/world/"}},
      {"sim", {"algo/types/", "algo/geometry/", "sim/"}},
      {"eval/metrics", {"algo/", "sim/", "eval/metrics/"}},
      {"eval/io", {"algo/", "sim/", "eval/io/"}},
      {"eval/config", {"algo/", "sim/", "eval/config/", "eval/io/"}},
      {"eval/report", {"algo/", "sim/", "eval/report/", "eval/io/", "eval/metrics/"}},
      {"eval/run",
       {"algo/", "sim/", "eval/run/", "eval/config/", "eval/io/", "eval/metrics/", "eval/report/"}},
      {"eval/study",
       {"algo/", "sim/", "eval/study/", "eval/run/", "eval/config/", "eval/io/", "eval/metrics/",
        "eval/report/"}},
      {"eval/cli", {"algo/", "sim/", "eval/"}},
  };
  return kAllowed;
}

/// Outside package -> the only folder or files (by beginning of the path) that include it.
const std::map<std::string, std::string>& package_doors() {
  static const std::map<std::string, std::string> kDoors = {
      {"CGAL/", "algo/delaunay/"},         {"nanoflann", "algo/geometry/kdtree"},
      {"embree3/", "sim/lidar/"},          {"hdf5", "eval/io/hdf5"},
      {"toml++/", "eval/config/toml_"},    {"CLI/", "eval/cli/"},
      {"Random123/", "algo/types/philox"}, {"openssl/", "eval/io/"},
      {"ceres/", "algo/slam/methods/"},    {"zlib", "eval/io/gzip"},
  };
  return kDoors;
}

const std::vector<std::string>* rules_of(const std::string& file) {
  const std::vector<std::string>* rules = nullptr;
  std::size_t longest = 0;
  for (const auto& [folder, allowed] : allowed_includes()) {
    if (starts_with(file, folder + "/") && folder.size() >= longest) {
      longest = folder.size();
      rules = &allowed;
    }
  }
  return rules;
}

bool any_start(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return starts_with(text, start); });
}

}  // namespace

Violations wrong_includes(const fs::path& root) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  Violations violations;
  for (const fs::path& file : sources(root, {"algo", "sim", "eval"})) {
    const std::string name = fs::relative(file, root).string();
    const auto* allowed = rules_of(name);
    for_each_line(file, [&](int number, const std::string& line) {
      std::smatch match;
      if (!std::regex_search(line, match, kInclude)) return;
      const std::string target = match[1];
      const bool ours = any_start(target, {"algo/", "sim/", "eval/", "tests/"});
      if (ours && (allowed == nullptr || !any_start(target, *allowed))) {
        violations.push_back(located(root, file, number, "may not include " + target));
      }
      for (const auto& [package, door] : package_doors()) {
        if (starts_with(target, package) && !starts_with(name, door)) {
          violations.push_back(
              located(root, file, number, target + " belongs behind " + door + " alone"));
        }
      }
    });
  }
  return violations;
}

Violations wrong_mains(const fs::path& root) {
  static const std::regex kMain(R"(^\s*int\s+main\s*\()");
  Violations violations;
  for (const fs::path& file : sources(root, {"algo", "sim", "eval"})) {
    if (starts_with(fs::relative(file, root).string(), "eval/cli/")) continue;
    for_each_line(file, [&](int number, const std::string& line) {
      if (std::regex_search(line, kMain)) {
        violations.push_back(located(root, file, number, "only eval/cli has a main"));
      }
    });
  }
  return violations;
}

Violations wrong_words(const fs::path& root) {
  // Spelled apart, so that this file does not hold them itself.
  static const std::regex kWords(std::string("(^|[^A-Za-z0-9_.])/(wo") + "rk|ro" + "ot|ho" +
                                 "me)/|\\b(TO" + "DO|FIX" + "ME|XX" + "X|HA" + "CK)\\b");
  Violations violations;
  for (const fs::path& file : sources(root, {"algo", "sim", "eval", "tests"})) {
    for_each_line(file, [&](int number, const std::string& line) {
      std::smatch match;
      if (std::regex_search(line, match, kWords)) {
        violations.push_back(located(root, file, number, "holds " + match.str()));
      }
    });
  }
  return violations;
}

Violations long_files(const fs::path& root) {
  constexpr int kMostLines = 300;
  Violations violations;
  for (const fs::path& file : sources(root, {"algo", "sim", "eval", "tests"})) {
    int lines = 0;
    for_each_line(file, [&](int number, const std::string&) { lines = number; });
    if (lines > kMostLines) {
      violations.push_back(located(root, file, lines, "is longer than 300 lines; divide it"));
    }
  }
  return violations;
}

Violations strange_top_level(const fs::path& root) {
  static const std::set<std::string> kPlan = {"CMakeLists.txt", "CMakePresets.json",
                                              "README.md",      "LICENSE",
                                              "CITATION.cff",   "CONTRIBUTING.md",
                                              "algo",           "sim",
                                              "eval",           "scenarios",
                                              "results",        "tests",
                                              "scripts",        ".ci",
                                              ".clang-format",  ".clang-tidy",
                                              ".gitignore",     ".git",
                                              "build",          "build-sanitize"};
  Violations violations;
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!kPlan.contains(name)) violations.push_back(name + ": not in the plan of the house");
  }
  return violations;
}

Violations unindexed_equations(const fs::path& root) {
  static const std::regex kCitation(R"(([A-Z][a-z]+[0-9]{4}) Eq\. \((\d+)\))");
  static const std::regex kPath(R"(`((algo|sim|eval|tests)/[A-Za-z0-9_/.]+)`)");
  std::set<std::string> indexed;
  Violations violations;
  for_each_line(root / "algo/README.md", [&](int number, const std::string& line) {
    if (!starts_with(line, "|")) return;
    for (std::sregex_iterator it(line.begin(), line.end(), kCitation), end; it != end; ++it) {
      indexed.insert(it->str());
    }
    for (std::sregex_iterator it(line.begin(), line.end(), kPath), end; it != end; ++it) {
      if (!fs::exists(root / it->str(1))) {
        violations.push_back(
            located(root, root / "algo/README.md", number, it->str(1) + " does not exist"));
      }
    }
  });
  for (const fs::path& file : sources(root, {"algo"})) {
    for_each_line(file, [&](int number, const std::string& line) {
      for (std::sregex_iterator it(line.begin(), line.end(), kCitation), end; it != end; ++it) {
        if (!indexed.contains(it->str())) {
          violations.push_back(
              located(root, file, number, it->str() + " is not in the index of algo/README.md"));
        }
      }
    });
  }
  return violations;
}

}  // namespace honka::architecture
