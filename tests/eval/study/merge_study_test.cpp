// What cannot be merged is refused with its place, and nothing is overwritten.
#include <catch2/catch.hpp>
#include <fstream>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/study/run_study.h"
#include "eval/study/study_status.h"
#include "tests/eval/study/fake_study.h"

namespace {

using namespace honka::eval;
using honka::test::fake_study;
using honka::test::TemporaryFolder;
using honka::test::user_error_of;
namespace fs = std::filesystem;

void run_all_shards(const StudyFolder& folder, const Study& study, std::int64_t count) {
  for (std::int64_t index = 0; index < count; ++index) {
    static_cast<void>(run_shard(folder, study, {index, count}, 1));
  }
}

}  // namespace

TEST_CASE("a missing shard is named, with the command that makes it") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 30);
  const StudyFolder out(folder / "out");
  run_all_shards(out, study, 3);
  fs::remove(out.finished({1, 3}));
  CHECK_THAT(user_error_of([&] { static_cast<void>(merge_study(out, study, "")); }),
             Catch::Contains("shard 1/3 is missing") && Catch::Contains("--shard 1/3"));
  CHECK_FALSE(fs::exists(folder / "out/summary.json"));
}

TEST_CASE("a shard that was cut short is named") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 30);
  const StudyFolder out(folder / "out");
  run_all_shards(out, study, 2);
  const auto file = out.finished({0, 2});
  fs::resize_file(file, fs::file_size(file) / 2);
  CHECK_THAT(user_error_of([&] { static_cast<void>(merge_study(out, study, "")); }),
             Catch::Contains("shard-0000-of-0002.h5"));
}

TEST_CASE("a shard under another's name overlaps, and one that is not of this study is foreign") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 30);
  const StudyFolder out(folder / "out");
  run_all_shards(out, study, 2);
  fs::copy_file(out.finished({0, 2}), out.finished({1, 2}), fs::copy_options::overwrite_existing);
  CHECK_THAT(user_error_of([&] { static_cast<void>(merge_study(out, study, "")); }),
             Catch::Contains("its shard is 0/2"));
  Study other = study;
  other.identity = "another";
  CHECK_THAT(user_error_of([&] { static_cast<void>(merge_study(out, other, "")); }),
             Catch::Contains("its identity is"));
}

TEST_CASE("shards of two divisions do not go into one folder") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 30);
  const StudyFolder out(folder / "out");
  run_all_shards(out, study, 2);
  CHECK_THAT(user_error_of([&] {
               static_cast<void>(run_shard(out, study, {0, 3}, 1));
             }),
             Catch::Contains("shards of 2, and this one is of 3"));
}

TEST_CASE("a folder with another study, or with other results, is left alone") {
  const TemporaryFolder folder;
  const Study study = fake_study(folder, 5);
  const StudyFolder out(folder / "out");
  run_all_shards(out, study, 1);
  Study other = study;
  other.identity = "another";
  CHECK_THAT(user_error_of([&] {
               static_cast<void>(run_shard(out, other, {0, 1}, 1));
             }),
             Catch::Contains("another study"));
  fs::create_directories(folder / "results");
  std::ofstream(folder / "results/summary.json") << "{}";
  CHECK_THAT(user_error_of([&] {
               static_cast<void>(run_shard(StudyFolder(folder / "results"), study, {0, 1}, 1));
             }),
             Catch::Contains("other results"));
  CHECK(read_text_file(folder / "results/summary.json") == "{}");
}

TEST_CASE("a folder without a study says so") {
  const TemporaryFolder folder;
  CHECK_THAT(user_error_of([&] { static_cast<void>(StudyFolder(folder.path()).manifest()); }),
             Catch::Contains("holds no study"));
  honka::test::write_raw(folder / "study.json", "{\"trials\": ");
  CHECK_THAT(user_error_of([&] { static_cast<void>(StudyFolder(folder.path()).manifest()); }),
             Catch::Contains("study.json: is damaged"));
}
