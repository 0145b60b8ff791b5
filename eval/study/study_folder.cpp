#include "eval/study/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "algo/types/user_error.h"
#include "eval/io/build_info.h"
#include "eval/io/safe_file.h"

namespace honka::eval {
namespace fs = std::filesystem;
namespace {

constexpr const char* kManifest = "study.json";
constexpr const char* kScenario = "scenario.toml";
constexpr const char* kBegun = ".journal";
constexpr const char* kFinished = ".h5";

std::string shard_name(const Shard& shard) {
  return fmt::format("shard-{:04}-of-{:04}", shard.index, shard.count);
}

/// The shard that a file of the folder shards/ belongs to; nothing for other files.
std::optional<Shard> shard_in(const fs::path& file) {
  Shard shard;
  char rest = 0;
  const std::string stem = file.stem().string();
  const bool read =
      std::sscanf(stem.c_str(), "shard-%ld-of-%ld%c", &shard.index, &shard.count, &rest) == 2;
  const std::string end = file.extension().string();
  if (!read || (end != kBegun && end != kFinished)) return std::nullopt;
  return shard;
}

[[noreturn]] void another_study(const fs::path& folder, const std::string& what) {
  throw UserError(fmt::format("{}: holds {}; give another --out, or move the folder away",
                              folder.string(), what));
}

}  // namespace

fs::path StudyFolder::journal(const Shard& shard) const {
  return path_ / "shards" / (shard_name(shard) + kBegun);
}

fs::path StudyFolder::finished(const Shard& shard) const {
  return path_ / "shards" / (shard_name(shard) + kFinished);
}

std::vector<Shard> StudyFolder::shards() const {
  std::vector<Shard> shards;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path_ / "shards", ignored)) {
    if (const auto shard = shard_in(entry.path())) shards.push_back(*shard);
  }
  std::sort(shards.begin(), shards.end(), [](const Shard& a, const Shard& b) {
    return std::pair(a.count, a.index) < std::pair(b.count, b.index);
  });
  shards.erase(std::unique(shards.begin(), shards.end()), shards.end());
  if (!shards.empty() && shards.front().count != shards.back().count) {
    throw UserError(
        fmt::format("{}: shards overlap: {} is of {}, {} of {}; keep those of one division",
                    (path_ / "shards").string(), shard_name(shards.front()), shards.front().count,
                    shard_name(shards.back()), shards.back().count));
  }
  return shards;
}

void StudyFolder::enter(const Study& study, const Shard& shard) const {
  if (fs::exists(path_ / kManifest)) {
    check_manifest(study);
  } else {
    for (const char* name : {"summary.json", "trials.h5", "report.html", "figures"}) {
      if (fs::exists(path_ / name)) another_study(path_, "other results");
    }
    write_manifest(study);
  }
  for (const Shard& other : shards()) {
    if (other.count == shard.count) continue;
    another_study(path_,
                  fmt::format("shards of {}, and this one is of {}", other.count, shard.count));
  }
  if (study.trials > manifest().trials) write_manifest(study);
}

StudyManifest StudyFolder::manifest() const {
  const fs::path file = path_ / kManifest;
  if (!fs::exists(file)) {
    throw UserError(fmt::format("{}: holds no study (no {}); give the folder that honka study made",
                                path_.string(), kManifest));
  }
  try {
    const auto json = nlohmann::json::parse(read_text_file(file));
    StudyManifest manifest;
    manifest.scenario = json.at("scenario").get<std::string>();
    manifest.overrides = json.at("overrides").get<std::vector<std::string>>();
    manifest.trials = json.at("trials").get<std::int64_t>();
    manifest.identity = json.at("identity").get<std::string>();
    manifest.version = json.at("version").get<std::string>();
    return manifest;
  } catch (const nlohmann::json::exception& error) {
    throw UserError(fmt::format("{}: is damaged: {}; make the study again in another folder",
                                file.string(), error.what()));
  }
}

Study StudyFolder::study() const {
  const StudyManifest manifest = this->manifest();
  const bool there = fs::exists(manifest.scenario);
  Study study = load_study(there ? manifest.scenario : path_ / kScenario, manifest.overrides,
                           manifest.trials);
  if (study.identity != manifest.identity) {
    throw UserError(fmt::format(
        "{}: {} is not what the study was run with ({} is); put that back, or run the study again "
        "in another folder",
        path_.string(), study.base.file.string(), (path_ / kScenario).string()));
  }
  return study;
}

void StudyFolder::write_manifest(const Study& study) const {
  nlohmann::ordered_json json;
  json["schema_version"] = 1;
  json["scenario"] = study.base.file.string();
  json["overrides"] = study.overrides;
  json["trials"] = study.trials;
  json["points"] = study.points.size();
  json["identity"] = study.identity;
  json["version"] = honka_version();
  fs::create_directories(path_ / "shards");
  write_file_safely(path_ / kScenario, read_text_file(study.base.file));
  write_file_safely(path_ / kManifest, json.dump(2) + "\n");
}

void StudyFolder::check_manifest(const Study& study) const {
  const StudyManifest there = manifest();
  if (there.identity != study.identity) {
    another_study(path_, "another study: its scenario or overrides differ");
  }
  if (there.version != honka_version()) {
    another_study(
        path_, fmt::format("trials of honka {}, and this is {}", there.version, honka_version()));
  }
}

std::string journal_title(const Study& study, const Shard& shard) {
  return fmt::format("honka study\t{}\t{}\t{}", study.identity, honka_version(), shard_name(shard));
}

std::string honka_version() {
  const BuildInfo info = build_info();
  constexpr std::size_t kDigits = 12;
  return fmt::format("{}, commit {}{}", info.version, info.commit.substr(0, kDigits),
                     info.dirty ? "+" : "");
}

}  // namespace honka::eval
