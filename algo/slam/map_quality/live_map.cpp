#include "algo/slam/map_quality/live_map.h"

#include <utility>

#include "algo/types/check.h"

namespace honka {

LiveMap::LiveMap(std::span<const SparseFrame> frames, FramePoses T_first_frame,
                 const BlurSettings& settings)
    : frames_(frames), T_first_frame_(std::move(T_first_frame)), settings_(settings) {
  HONKA_CHECK(frames_.size() == T_first_frame_.size(), "one pose a frame");
  std::size_t points = 0;
  for (const SparseFrame& frame : frames_) {
    starts_.push_back(points);
    points += frame.points_m.size();
  }
  points_m_.resize(points);
  lay_out_from(0);
}

void LiveMap::move_after(std::size_t j, FramePoses T_first_frame) {
  HONKA_CHECK(frames_.size() == T_first_frame.size(), "one pose a frame");
  T_first_frame_ = std::move(T_first_frame);
  lay_out_from(j + 1);
}

void LiveMap::lay_out_from(std::size_t first) {
  for (std::size_t l = first; l < frames_.size(); ++l) {
    const Eigen::Matrix3d R = T_first_frame_[l].linear();
    const Eigen::Vector3d t = T_first_frame_[l].translation();
    Eigen::Vector3d* place = points_m_.data() + starts_[l];
    for (const Eigen::Vector3d& point : frames_[l].points_m) *place++ = R * point + t;
  }
  blur_ = honka::blur(points_m_, settings_);
}

}  // namespace honka
