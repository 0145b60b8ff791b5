#pragma once

#include <filesystem>
#include <string>

namespace honka::eval {

/// Judges poses (TUM, T_world_lidar) and, where given, stems (CSV, world frame) made elsewhere from
/// a recording, against the truth that it holds. The answer is one JSON object: `associated`,
/// `estimate_poses`, `ape` without alignment, `ape_se3` after rigid alignment (Umeyama 1991;
/// null where too few poses or a straight path leave it open), and
/// `stems` with precision, recall, F1 and position RMSE. Truth is interpolated at the estimate's
/// times; estimates outside the recording's time are not associated. UserError for bad files, and
/// where no pose can be associated.
[[nodiscard]] std::string score(const std::filesystem::path& recording,
                                const std::filesystem::path& poses,
                                const std::filesystem::path& stems);

}  // namespace honka::eval
