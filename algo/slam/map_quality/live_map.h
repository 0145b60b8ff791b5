#pragma once

#include <span>
#include <vector>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/sparse_frame.h"

namespace honka {

/// A map whose poses change while its frames stay: after each change only the frames that moved are
/// laid out again, and β is measured. Nevalainen2021 §2.2, §2.5.
class LiveMap {
 public:
  /// As many poses as frames; the frames must outlive the map.
  LiveMap(std::span<const SparseFrame> frames, FramePoses T_first_frame,
          const BlurSettings& settings);

  [[nodiscard]] const FramePoses& poses() const { return T_first_frame_; }
  /// All points in the first frame, frame by frame.
  [[nodiscard]] std::span<const Eigen::Vector3d> points_m() const { return points_m_; }
  [[nodiscard]] double blur() const { return blur_; }

  /// Other poses for the frames after j; those up to j must be the ones it has.
  void move_after(std::size_t j, FramePoses T_first_frame);

 private:
  void lay_out_from(std::size_t first);

  std::span<const SparseFrame> frames_;
  FramePoses T_first_frame_;
  BlurSettings settings_;
  std::vector<std::size_t> starts_;
  std::vector<Eigen::Vector3d> points_m_;
  double blur_ = 0.0;
};

}  // namespace honka
