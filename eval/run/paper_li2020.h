#pragma once

#include <cstdint>
#include <optional>

namespace honka::eval {

/// What Li et al. 2020 print for windows of so many frames (Table 1, Figures 8-10, section 3.2).
struct PaperRow {
  std::int64_t frames = 0;
  double trunks = 0.0, matching_triangles = 0.0, success_rate = 0.0;
  std::optional<double> time_s;            ///< "about", section 3.2
  std::optional<double> max_rotation_deg;  ///< of one frame alone
};

/// Figures that hold for every row.
inline constexpr double kPaperTranslationMean_m = 0.2;
inline constexpr double kPaperTranslationSd_m = 0.14;
inline constexpr double kPaperTranslationMax_m = 0.5;

/// The paper's row, where it has one for this number of frames.
[[nodiscard]] inline std::optional<PaperRow> paper_row(std::int64_t frames) {
  switch (frames) {
    case 1:
      return PaperRow{1, 54.09, 1.71, 0.2289, 0.1, 2.23};
    case 3:
      return PaperRow{3, 122.98, 4.97, 0.8879, std::nullopt, std::nullopt};
    case 5:
      return PaperRow{5, 139.54, 10.22, 0.9928, std::nullopt, std::nullopt};
    case 10:
      return PaperRow{10, 133.96, 14.37, 1.0, 0.6, std::nullopt};
    default:
      return std::nullopt;
  }
}

}  // namespace honka::eval
