#include "eval/study/journal.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "tests/eval/io/temporary_folder.h"

namespace {

using namespace honka::eval;
using honka::test::TemporaryFolder;

TrialRecord numbered_record(std::int64_t trial) {
  TrialRecord record;
  record.id = {0, trial};
  record.results = {{"a", {static_cast<double>(trial)}}};
  return record;
}

std::vector<std::int64_t> trials_of_journal(const std::filesystem::path& file) {
  std::vector<std::int64_t> trials;
  const Journal journal(file, "title", [&](const TrialRecord& r) { trials.push_back(r.id.trial); });
  return trials;
}

void fill_journal(const std::filesystem::path& file, int records) {
  Journal journal(file, "title", [](const TrialRecord&) {});
  for (int k = 0; k < records; ++k) journal.append(numbered_record(k));
}

}  // namespace

TEST_CASE("a journal gives back what was put in, and takes more") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal";
  fill_journal(file, 2);
  CHECK(trials_of_journal(file) == std::vector<std::int64_t>{0, 1});
  {
    Journal journal(file, "title", [](const TrialRecord&) {});
    journal.append(numbered_record(7));
  }
  CHECK(trials_of_journal(file) == std::vector<std::int64_t>{0, 1, 7});
  CHECK(peek_journal(file).size() == 3);
}

TEST_CASE("cut anywhere, a journal keeps its whole lines and goes on behind them") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal";
  fill_journal(file, 3);
  const std::string text = read_text_file(file);
  std::size_t kept = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    std::ofstream(file, std::ios::trunc) << text.substr(0, length);
    const auto trials = trials_of_journal(file);
    CHECK(trials.size() >= kept);
    kept = trials.size();
    Journal journal(file, "title", [](const TrialRecord&) {});
    journal.append(numbered_record(99));
    CHECK(peek_journal(file).size() == kept + 1);
  }
  CHECK(kept == 3);
}

TEST_CASE("a damaged line before the last is an error with its place") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal";
  fill_journal(file, 3);
  std::string text = read_text_file(file);
  text[text.find('\n', text.find('\n') + 1) - 1] = 'x';
  std::ofstream(file, std::ios::trunc) << text;
  CHECK_THROWS_WITH(trials_of_journal(file), Catch::Contains("journal:2: damaged"));
}

TEST_CASE("a journal of something else is left alone") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal";
  std::ofstream(file) << "dear diary\n";
  CHECK_THROWS_AS(trials_of_journal(file), honka::UserError);
  CHECK(read_text_file(file) == "dear diary\n");
}

TEST_CASE("two on one journal: the second is refused") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal";
  CHECK_FALSE(is_locked(file));
  {
    const Journal first(file, "title", [](const TrialRecord&) {});
    CHECK(is_locked(file));
    CHECK_THROWS_WITH(trials_of_journal(file), Catch::Contains("another process"));
  }
  CHECK_FALSE(is_locked(file));
  CHECK(trials_of_journal(file).empty());
}
