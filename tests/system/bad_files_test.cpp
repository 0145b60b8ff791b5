// What bad stem lists, poses and recordings get, and folders that cannot be written.
#include <sys/mount.h>

#include "eval/io/table.h"
#include "tests/system/program.h"

namespace {

using honka::test::check_refused;
using honka::test::contents;
using honka::test::run_honka;
using honka::test::TemporaryFolder;
using honka::test::write_raw;
using honka::test::write_tiny;
namespace fs = std::filesystem;

const std::string kCases = HONKA_SOURCE_DIR "/tests/data/localization_cases/exact/";

/// A disk of so many bytes mounted on a folder; only root may do this.
class SmallDisk {
 public:
  SmallDisk(const fs::path& folder, const std::string& size) : folder_(folder) {
    fs::create_directories(folder);
    mounted_ = ::mount("tmpfs", folder.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount(folder_.c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  [[nodiscard]] bool mounted() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

}  // namespace

TEST_CASE("bad stem lists are refused with file, line and column") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    write_raw(folder / "stems.csv", text);
    for (const auto& files : {std::vector<std::string>{"stems.csv", kCases + "exact_n1_k12.csv"},
                              std::vector<std::string>{kCases + "map.csv", "stems.csv"}}) {
      check_refused(run_honka({"locate", files[0], files[1]}, folder.path()), parts);
    }
  };
  refused("", {"stems.csv: empty", "x_m,y_m"});
  refused("x_m,y_m\n1,2\n3,nan\n", {"stems.csv:3:3: ", "'y_m'", "not finite"});
  refused("x_m,y_m\n1,two\n", {"stems.csv:2:3: ", "'y_m'", "two"});
  refused("x_m,y_m\n1\n", {"stems.csv:2:1: "});
  refused("east,north\n1,2\n", {"stems.csv:1:1: ", "no column 'x_m'"});
  write_raw(folder / "stems.csv", "x_m,y_m\n");  // a map; a sensor that saw none is answered
  check_refused(run_honka({"locate", "stems.csv", kCases + "exact_n1_k12.csv"}, folder.path()),
                {"stems.csv:1:1: ", "no stems"});
  check_refused(run_honka({"locate", "none.csv", "stems.csv"}, folder.path()),
                {"none.csv: no such file"});
  CHECK(folder.entries() == 1);
}

TEST_CASE("a map of two stems is refused, a local list of two stems is answered") {
  const TemporaryFolder folder;
  write_raw(folder / "two.csv", "x_m,y_m\n1,2\n3,4\n");
  check_refused(run_honka({"locate", "two.csv", kCases + "exact_n1_k12.csv"}, folder.path()),
                {"two.csv: ", "2 stems", "give a map of more stems"});
  const auto answer = run_honka({"locate", kCases + "map.csv", "two.csv", "--json"}, folder.path());
  CHECK(answer.exit_code == 0);
  const auto json = honka::test::Json::parse(answer.out);
  CHECK(json["verdict"] == "too_few_stems");
  CHECK(json["x_m"].is_null());
}

TEST_CASE("unknown methods and bad tolerances are refused") {
  const TemporaryFolder folder;
  const std::string map = kCases + "map.csv", local = kCases + "exact_n1_k12.csv";
  check_refused(run_honka({"locate", map, local, "--method", "guess"}, folder.path()),
                {"--method", "\"guess\"", "li2020"});
  check_refused(run_honka({"locate", map, local, "--tolerance-m2", "-1"}, folder.path()),
                {"--tolerance-m2"});
  check_refused(run_honka({"locate", map, local, "--tolerance-m2", "nan"}, folder.path()),
                {"--tolerance-m2", "finite"});
}

TEST_CASE("truncated and foreign recordings and bad poses are refused") {
  const TemporaryFolder folder;
  write_tiny(folder);
  REQUIRE(run_honka({"simulate", "tiny.toml", "--out", "drive.h5", "-s", "simulate.duration_s=0.3"},
                    folder.path())
              .exit_code == 0);
  const std::string whole = honka::test::read_text(folder / "drive.h5");
  write_raw(folder / "cut.h5", whole.substr(0, whole.size() / 2));
  write_raw(folder / "text.h5", "not HDF5");
  honka::eval::write_trials_h5(folder / "trials.h5", {}, {}, {});
  write_raw(folder / "good.tum", "0.05 0 0 0 0 0 0 1\n");
  const auto refused = [&](const std::string& recording, const std::string& poses,
                           const std::vector<std::string>& parts) {
    check_refused(run_honka({"score", recording, poses}, folder.path()), parts);
  };
  refused("cut.h5", "good.tum", {"cut.h5: ", "truncated", "make it again"});
  refused("text.h5", "good.tum", {"text.h5: not an HDF5 file"});
  refused("trials.h5", "good.tum", {"trials.h5: not a honka recording", "honka simulate"});
  refused("none.h5", "good.tum", {"none.h5: no such file"});
  refused("drive.h5", "none.tum", {"none.tum: no such file"});
  write_raw(folder / "short.tum", "0.05 0 0 0 0 0 0\n");
  refused("drive.h5", "short.tum", {"short.tum:1:1: ", "8"});
  write_raw(folder / "late.tum", "1000 0 0 0 0 0 0 1\n");
  refused("drive.h5", "late.tum", {"late.tum: ", "within the recording"});
}

TEST_CASE("folders and files that are not ours are never replaced") {
  const TemporaryFolder folder;
  write_tiny(folder);
  write_raw(folder / "file", "mine");
  fs::create_directories(folder / "foreign");
  write_raw(folder / "foreign/notes.txt", "mine");
  const auto before = contents(folder.path());
  const auto run_into = [&](const std::string& out) {
    return run_honka({"run", "tiny.toml", "--out", out}, folder.path());
  };
  check_refused(run_into("file"), {"file: is a file, not a folder", "--out"});
  check_refused(run_into("foreign"), {"foreign: ", "not replaced", "another name"});
  check_refused(run_into("file/out"), {"file", "cannot be written", "give another folder"});
  check_refused(run_into("/proc/honka"), {"/proc/honka", "cannot be written"});
  check_refused(run_honka({"simulate", "tiny.toml", "--out", "foreign"}, folder.path()),
                {"foreign: cannot be written", "give the name of a file"});
  check_refused(
      run_honka({"simulate", "tiny.toml", "--out", "late.h5", "-s", "simulate.start_s=1e5"},
                folder.path()),
      {"-s simulate.start_s=1e5: ", "simulate.start_s", "beyond the drive"});
  CHECK(contents(folder.path()) == before);
}

TEST_CASE("a full disk ends a run in one line, leaves no part and keeps the old results") {
  const TemporaryFolder folder;
  write_tiny(folder);
  const SmallDisk disk(folder / "disk", "1m");
  if (!disk.mounted()) {
    WARN("skipped: a small disk cannot be mounted without root");
    return;
  }
  fs::create_directories(folder / "disk/old");
  write_raw(folder / "disk/old/summary.json", "old");
  for (const std::string out : {"disk/new", "disk/old"}) {
    check_refused(run_honka({"run", "tiny.toml", "--out", out}, folder.path()),
                  {out, "No space left on device", "free some space"});
  }
  check_refused(run_honka({"simulate", "tiny.toml", "--out", "disk/drive.h5"}, folder.path()),
                {"disk/drive.h5", "No space left on device", "free some space"});
  const std::vector<std::pair<std::string, std::string>> kOld = {{"old/summary.json", "old"}};
  CHECK(contents(folder / "disk") == kOld);
}
