#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/run/check/figures.h"

namespace honka::eval {

inline constexpr const char* kTrajectoryTable = "trajectory";

/// An estimated trajectory of a results folder and the true one beside it.
struct TrackFiles {
  std::filesystem::path truth, estimate;  ///< relative to the folder

  bool operator==(const TrackFiles&) const = default;
};

/// The TUM files of a results folder that have a truth: PRE_truthPOST.tum is that of every
/// PRE_*POST.tum and PREPOST.tum in its folder, the one with most letters in common where several
/// fit. In the order of their names.
[[nodiscard]] std::vector<TrackFiles> tracks_with_truth(const std::filesystem::path& folder);

/// Stores the truths of a results folder, every n-th pose so that about 200 remain, below
/// `references`/trajectories/`name`, and judges the estimates by them: rows
/// "truth=FILE; estimate=FILE; align=yaw", columns ape_m, ape_deg and, between neighbouring stored
/// poses, rpe_m, rpe_deg, each an RMSE with a tolerance.
[[nodiscard]] std::vector<CheckFigure> accept_tracks(const std::filesystem::path& folder,
                                                     const std::filesystem::path& references,
                                                     const std::string& name);

/// Judges the estimates in `folder` by the stored truths that the rows of a reference name;
/// estimates that are not there give no figures. UserError for a truth that is not there, for
/// files that are no trajectories and for a row that names none.
[[nodiscard]] std::vector<CheckFigure> track_figures(const std::vector<CheckFigure>& reference,
                                                     const std::filesystem::path& folder,
                                                     const std::filesystem::path& references);

}  // namespace honka::eval
