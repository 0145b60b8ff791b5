#include "eval/run/check/track_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "algo/types/user_error.h"
#include "eval/io/tum.h"
#include "eval/metrics/trajectory_alignment.h"
#include "eval/metrics/trajectory_errors.h"

namespace honka::eval {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStoredPoses = 200;
/// Of one moment: 10 Hz sweeps lie 0.1 s apart.
constexpr double kSameMoment_s = 0.02;
constexpr const char* kTruth = "_truth";
/// One path is one draw: what its errors may grow by.
constexpr double kAllowed = 0.25;

/// The names of a truth and its estimate, and how they are compared.
struct TrackRow {
  std::string truth, estimate, align = "yaw";

  [[nodiscard]] std::string label() const {
    return "truth=" + truth + "; estimate=" + estimate + "; align=" + align;
  }
};

std::vector<fs::path> tum_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".tum") {
      files.push_back(fs::relative(entry.path(), folder));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Letters that an estimate's name shares with that of a truth; nothing where it is not of it.
std::optional<std::size_t> shared_letters(const fs::path& truth, const fs::path& estimate) {
  const std::string name = truth.stem().string(), other = estimate.stem().string();
  const std::size_t at = name.find(kTruth);
  if (at == std::string::npos || truth.parent_path() != estimate.parent_path()) return {};
  const std::string before = name.substr(0, at);
  const std::string after = name.substr(at + std::string_view(kTruth).size());
  if (other == before + after) return name.size();
  if (!other.starts_with(before + "_") || !other.ends_with(after)) return {};
  return before.size() + after.size();
}

std::vector<TimedPose> thinned(const std::vector<TimedPose>& poses) {
  const std::size_t step = std::max<std::size_t>(1, poses.size() / kStoredPoses);
  std::vector<TimedPose> kept;
  for (std::size_t i = 0; i < poses.size(); i += step) kept.push_back(poses[i]);
  return kept;
}

std::vector<double> times_of(const std::vector<TimedPose>& poses) {
  std::vector<double> times;
  for (const TimedPose& pose : poses) times.push_back(pose.time_s);
  return times;
}

PosePairs pairs_of(const fs::path& truth_file, const fs::path& estimate_file) {
  const auto truth = read_tum(truth_file), estimate = read_tum(estimate_file);
  PosePairs pairs;
  for (const TimePair& pair : associate_times(times_of(truth), times_of(estimate), kSameMoment_s)) {
    const TimedPose& estimated = estimate[pair.estimate];
    pairs.poses.push_back({estimated.time_s, truth[pair.truth].pose, estimated.pose});
  }
  return pairs;
}

void append_errors(const TrackRow& row, const std::string& name, const TrajectoryErrors& errors,
                   std::vector<CheckFigure>& figures) {
  const std::pair<std::string, const std::vector<double>*> kinds[] = {
      {name + "_m", &errors.translation_m}, {name + "_deg", &errors.rotation_deg}};
  for (const auto& [column, values] : kinds) {
    CheckFigure figure{kTrajectoryTable, row.label(), column, {}, "null", 0.0};
    if (const auto statistics = trajectory_statistics(*values)) {
      figure.number = statistics->rmse;
      figure.word.clear();
      figure.tolerance = std::max(kAllowed * statistics->rmse, 1e-9);
    }
    figures.push_back(std::move(figure));
  }
}

/// Nothing where no alignment is defined: an estimate that stays where it began.
void append_track(const TrackRow& row, const PosePairs& pairs, std::vector<CheckFigure>& figures) {
  const auto alignment = alignment_of(row.align);
  if (!alignment) {
    throw UserError(fmt::format("\"{}\": unknown align; give none, origin, yaw, se2, se3 or sim3",
                                row.label()));
  }
  const AlignmentResult aligned = align(pairs, *alignment);
  if (aligned.status != AlignmentStatus::kAligned) return;
  const PosePairs judged = moved(pairs, aligned.T_truth_estimate);
  append_errors(row, "ape", absolute_errors(judged), figures);
  const RelativeSettings neighbours{1.0, DeltaUnit::kFrames, true};
  append_errors(row, "rpe", relative_errors(judged, motions(judged, neighbours)), figures);
}

/// What stands after "key=" in a row's name, up to the next cell.
std::string named_in(const std::string& row, const std::string& key) {
  const std::size_t at = fmt::format("; {}", row).find(fmt::format("; {}=", key));
  if (at == std::string::npos) {
    throw UserError(
        fmt::format("trajectory row \"{}\": no {}=…; write it as \"truth=FILE; "
                    "estimate=FILE; align=yaw\"",
                    row, key));
  }
  const std::size_t begin = at + key.size() + 1;
  return row.substr(begin, row.find("; ", begin) - begin);
}

}  // namespace

std::vector<TrackFiles> tracks_with_truth(const fs::path& folder) {
  const auto files = tum_files(folder);
  std::vector<TrackFiles> tracks;
  for (const fs::path& file : files) {
    if (file.stem().string().find(kTruth) != std::string::npos) continue;
    TrackFiles track{{}, file};
    std::size_t most = 0;
    for (const fs::path& truth : files) {
      const auto letters = shared_letters(truth, file);
      if (!letters || (!track.truth.empty() && *letters <= most)) continue;
      track.truth = truth;
      most = *letters;
    }
    if (!track.truth.empty()) tracks.push_back(track);
  }
  return tracks;
}

std::vector<CheckFigure> accept_tracks(const fs::path& folder, const fs::path& references,
                                       const std::string& name) {
  const fs::path below = fs::path("trajectories") / name;
  if (fs::exists(references / below)) {
    for (const fs::path& old : tum_files(references / below)) fs::remove(references / below / old);
  }
  std::vector<CheckFigure> figures;
  for (const TrackFiles& track : tracks_with_truth(folder)) {
    const TrackRow row{(below / track.truth).generic_string(), track.estimate.generic_string()};
    const fs::path stored = references / row.truth;
    if (!fs::exists(stored)) write_tum(stored, thinned(read_tum(folder / track.truth)));
    append_track(row, pairs_of(stored, folder / track.estimate), figures);
  }
  return figures;
}

std::vector<CheckFigure> track_figures(const std::vector<CheckFigure>& reference,
                                       const fs::path& folder, const fs::path& references) {
  std::set<std::string> done;
  std::vector<CheckFigure> figures;
  for (const CheckFigure& figure : reference) {
    if (figure.table != kTrajectoryTable || !done.insert(figure.row).second) continue;
    const TrackRow row{named_in(figure.row, "truth"), named_in(figure.row, "estimate"),
                       named_in(figure.row, "align")};
    if (!fs::exists(folder / row.estimate)) continue;
    append_track(row, pairs_of(references / row.truth, folder / row.estimate), figures);
  }
  return figures;
}

}  // namespace honka::eval
