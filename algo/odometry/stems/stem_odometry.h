#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/odometry/key_frames.h"
#include "algo/odometry/odometry.h"
#include "algo/odometry/stems/ground_plane.h"
#include "algo/odometry/stems/landmarks.h"
#include "algo/odometry/stems/motion.h"
#include "algo/odometry/stems/registration.h"
#include "algo/odometry/stems/settings.h"
#include "algo/odometry/stems/stem_points.h"
#include "algo/odometry/sweep_order.h"

namespace honka {

/// The cheap odometry on stems and ground, after the edge of Nevalainen2021: each sweep's stems are
/// registered to a map of all stems seen so far, the ground gives roll, pitch and height.
///
/// Memory is bounded by `landmarks.max_landmarks` and `ground.cells`. The same sweeps give the same
/// digits.
class StemOdometry : public Odometry {
 public:
  StemOdometry(const LidarModel& model, const StemOdometrySettings& settings);
  [[nodiscard]] OdometryEstimate process(const Sweep& sweep) override;

  [[nodiscard]] std::size_t landmarks() const { return stems_.size(); }

 private:
  struct Outcome {
    StemFit fit;
    OdometryStatus status = OdometryStatus::kRegistered;
    OdometryCause cause = OdometryCause::kNone;
  };
  /// What a sweep shows, at the time of each return.
  struct Features {
    StemPoints points;
    std::vector<GroundPoint> ground;
  };
  void start(const Sweep& sweep);
  void predict(double elapsed_s);
  void find_features(const Sweep& sweep);
  [[nodiscard]] StemFit register_features();
  [[nodiscard]] Outcome judge(const StemFit& fit, OdometryCause cause_before) const;
  [[nodiscard]] Outcome search(const Outcome& lost, OdometryCause cause_before);
  void accept(const Outcome& outcome);
  void count_lost();
  [[nodiscard]] Outcome start_again_in_motion(const Outcome& second, double elapsed_s);
  void learn(const Outcome& outcome);
  void add_to_maps(std::span<const StemPair> pairs);
  void clear_maps();
  [[nodiscard]] OdometryEstimate estimate(const Sweep& sweep, const Outcome& outcome);
  [[nodiscard]] OdometryEstimate refused(const Sweep& sweep, OdometryCause cause) const;
  [[nodiscard]] Eigen::Vector3d up_in_lidar() const;

  LidarModel model_;
  StemOdometrySettings settings_;
  SweepOrder order_;
  StemPointFinder finder_;
  GroundPicker picker_;
  StemLandmarkMap stems_;
  GroundMap ground_;
  StemRegistration registration_;
  MotionFilter motion_;

  KeyFrameSelector key_frames_;

  Features features_;
  PlacedSweep placed_;
  std::optional<Features> first_;  ///< until the second sweep tells how the first moved
  bool started_ = false;
  double coasted_s_ = 0.0;        ///< time since the last registration
  StemLandmarkMap lost_stems_;    ///< of the last sweep that found no place
  std::int64_t lost_sweeps_ = 0;  ///< of such sweeps in a row that resemble each other
  OdometryEstimate last_;
};

}  // namespace honka
