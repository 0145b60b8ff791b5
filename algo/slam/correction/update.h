#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/sparse_frame.h"

namespace honka {

/// On which side of t_lj the share of the correction acts.
enum class UpdateSide : std::uint8_t {
  kRight,  ///< t_j1 t_lj (t_ij⁻¹ t'_ij)^u, Eq. 19 as printed: in the axes of frame l
  kLeft,   ///< t_j1 (t'_ij t_ij⁻¹)^u t_lj: in the axes of frame j
};

/// right | left, in this order.
[[nodiscard]] const std::vector<std::string>& update_side_names();
/// HONKA_CHECKs that the name is one of these.
[[nodiscard]] UpdateSide update_side(const std::string& name);

/// A match of two frames that is to hold in the map.
struct Correction {
  std::size_t j = 0, i = 0;  ///< j < i, positions in the chain
  Pose3 T_j_i = Pose3::Identity();
};

/// Squeezes the poses so that T_j⁻¹ T_i becomes the correction's: frames j + 1 … i take the share
/// `shares[l − j]` of it (shares[0] = 0, shares[i − j] = 1; as power_coefficients gives them), the
/// frames after i follow rigidly, those up to j stay. Rotations are made orthonormal again.
/// Source: Nevalainen2021 Eqs. 19–20.
void apply_correction(FramePoses& T_first_frame, const Correction& correction,
                      std::span<const double> shares, UpdateSide side);

}  // namespace honka
