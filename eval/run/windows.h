#pragma once

#include <cstdint>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/drive.h"
#include "eval/run/localization_row.h"
#include "eval/run/trunk_map.h"

namespace honka::eval {

/// The run that is localized: key frames and, beside each, its scans.
struct ScannedRun {
  const Drive* drive = nullptr;
  const LidarModel* model = nullptr;
  std::vector<std::vector<Sweep>> scans;  ///< one entry a key frame
};

/// Consecutive key frames; a row of n frames takes the last n, so that all rows of a window answer
/// for the same place: that of its last key frame.
struct Window {
  std::int64_t number = 0;
  std::size_t last_key_frame = 0;
  std::vector<std::int64_t> frames;  ///< the rows that it gets
};

/// Windows of max(frames) key frames that share none, in the order of the drive; when there are
/// more than `protocol.windows` (and that is not 0), evenly chosen ones. With `protocol.windows_of`
/// "each" that is done for each number of frames apart; windows of different numbers then overlap.
[[nodiscard]] std::vector<Window> disjoint_windows(std::size_t key_frames,
                                                   const ProtocolSettings& protocol);

/// The cloud of the last n key frames of a window, in the levelled frame of its last key frame.
[[nodiscard]] LocalCloud window_cloud(const ScannedRun& run, const Window& window,
                                      std::int64_t frames, const KeyFrameSettings& settings);

/// Truth that windows are judged by.
struct WindowTruth {
  const StemMap* stems_in_world = nullptr;
  std::int64_t trial = 0;
};

/// Localizes one window in every number of frames by every variant; rows in that order.
[[nodiscard]] std::vector<LocalizationRow> localize_window(const Window& window,
                                                           const ScannedRun& run,
                                                           const std::vector<Variant>& variants,
                                                           const Scenario& scenario,
                                                           const WindowTruth& truth);

}  // namespace honka::eval
