#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/study/shard.h"
#include "eval/study/study.h"

namespace honka::eval {

/// What study.json of a study's folder holds: enough to find the scenario again, and to tell one
/// study, and one version of honka, from another.
struct StudyManifest {
  std::filesystem::path scenario;      ///< as given; a copy lies in the folder
  std::vector<std::string> overrides;  ///< "key=value"
  std::int64_t trials = 0;             ///< at each point
  std::string identity;                ///< Study::identity
  std::string version;                 ///< of honka, with its commit
};

/// The folder of a study: study.json, scenario.toml, shards/ and, once merged, the results.
class StudyFolder {
 public:
  explicit StudyFolder(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path journal(const Shard& shard) const;
  [[nodiscard]] std::filesystem::path finished(const Shard& shard) const;
  /// The shards of which a file is there, begun or finished, in order. UserError at shards of two
  /// divisions.
  [[nodiscard]] std::vector<Shard> shards() const;

  /// Makes the folder for a study, or checks that it is that study's; more trials than it had are
  /// taken over. UserError at another study or version of honka, at shards of another division, and
  /// at a folder with other things in it; nothing is overwritten.
  void enter(const Study& study, const Shard& shard) const;

  /// UserError where the folder holds no study.
  [[nodiscard]] StudyManifest manifest() const;
  /// The study of the manifest. UserError where its scenario has changed since.
  [[nodiscard]] Study study() const;

 private:
  void write_manifest(const Study& study) const;
  void check_manifest(const Study& study) const;

  std::filesystem::path path_;
};

/// First line of a shard's journal.
[[nodiscard]] std::string journal_title(const Study& study, const Shard& shard);

/// Writes the trials of a finished shard, safely: a trials.h5 with what the shard is of.
void write_shard(const StudyFolder& folder, const Study& study, const Shard& shard,
                 std::vector<TrialRecord> records);

/// The rows of a finished shard. UserError where the file is cut short or of another study,
/// division or version of honka.
[[nodiscard]] Table read_shard(const StudyFolder& folder, const Study& study, const Shard& shard);

/// Records that study_table() makes these rows of.
[[nodiscard]] std::vector<TrialRecord> records_of(const Study& study, const Table& rows);

/// "1.0.0, commit 0123abcd", with "+" where files differed from the commit.
[[nodiscard]] std::string honka_version();

}  // namespace honka::eval
