#include "algo/slam/correction/update.h"

#include <algorithm>

#include "algo/geometry/se3_power.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// Many products wear a rotation; this makes it one again.
Pose3 orthonormal(const Pose3& pose) {
  Pose3 clean = pose;
  clean.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return clean;
}

}  // namespace

const std::vector<std::string>& update_side_names() {
  static const std::vector<std::string> kNames = {"right", "left"};
  return kNames;
}

UpdateSide update_side(const std::string& name) {
  const auto& names = update_side_names();
  const auto found = std::find(names.begin(), names.end(), name);
  HONKA_CHECK(found != names.end(), "the name of a side");
  return static_cast<UpdateSide>(found - names.begin());
}

void apply_correction(FramePoses& T_first_frame, const Correction& correction,
                      std::span<const double> shares, UpdateSide side) {
  const auto [j, i, T_j_i_new] = correction;
  HONKA_CHECK(j < i && i < T_first_frame.size(), "a correction ties two frames of the map");
  HONKA_CHECK(shares.size() == i - j + 1, "one share a frame from j to i");
  HONKA_CHECK(T_j_i_new.matrix().allFinite(), "a finite correction");
  const Pose3 T_first_j = T_first_frame[j], T_j_first = T_first_j.inverse();
  const Pose3 T_j_i = T_j_first * T_first_frame[i];
  const Pose3 T_i_first = T_first_frame[i].inverse();

  // Nevalainen2021 Eq. (19), and its left form
  const bool right = side == UpdateSide::kRight;
  const PosePower delta(right ? T_j_i.inverse() * T_j_i_new : T_j_i_new * T_j_i.inverse());
  for (std::size_t l = j + 1; l <= i; ++l) {
    const Pose3 share = delta(shares[l - j]);
    const Pose3 T_first_l = T_first_frame[l];
    T_first_frame[l] =
        orthonormal(right ? T_first_l * share : T_first_j * share * (T_j_first * T_first_l));
  }

  // Nevalainen2021 Eq. (20)
  const Pose3 T_new_old = T_first_frame[i] * T_i_first;
  for (std::size_t k = i + 1; k < T_first_frame.size(); ++k) {
    T_first_frame[k] = orthonormal(T_new_old * T_first_frame[k]);
  }
}

}  // namespace honka
