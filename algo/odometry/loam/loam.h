#pragma once

#include <cstdint>
#include <optional>

#include "algo/odometry/key_frames.h"
#include "algo/odometry/loam/loam_map.h"
#include "algo/odometry/loam/matching.h"
#include "algo/odometry/loam/motion.h"
#include "algo/odometry/loam/settings.h"
#include "algo/odometry/odometry.h"
#include "algo/odometry/sweep_order.h"

namespace honka {

/// Lidar odometry and mapping (Zhang2014) on the axes of stems and the ground.
///
/// Two rates: each sweep is registered with part of its features, a key frame (0.3 m or 30°) once
/// more with all of them, and then becomes part of the map. The map is the one reference of both.
/// Memory is bounded by LoamMapSettings. Bad input: see process() of Odometry and the README.
class LoamOdometry : public Odometry {
 public:
  LoamOdometry(const LidarModel& model, const LoamSettings& settings);

  [[nodiscard]] OdometryEstimate process(const Sweep& sweep) override;

  [[nodiscard]] const LoamMap& map() const { return map_; }
  /// Of the last sweep that had features.
  [[nodiscard]] const LoamRegistration& last_registration() const { return last_registration_; }

 private:
  struct Judgement {
    OdometryStatus status = OdometryStatus::kRegistered;
    OdometryCause cause = OdometryCause::kNone;
  };
  [[nodiscard]] OdometryEstimate start(const Sweep& sweep, const LoamFeatures& features,
                                       OdometryCause cause);
  [[nodiscard]] LoamRegistration register_sweep(const LoamFeatures& features);
  [[nodiscard]] LoamRegistration restart_in_motion(const LoamFeatures& features,
                                                   const LoamRegistration& found);
  [[nodiscard]] Judgement judge(const LoamFeatures& features, LoamRegistration& found);
  void map_key_frame(const LoamFeatures& features, LoamRegistration& found);
  void carry_on(const LoamFeatures& features, const LoamRegistration& found, Judgement judgement);
  [[nodiscard]] OdometryEstimate answer(const Sweep& sweep, const Covariance6& covariance,
                                        Judgement judgement);

  LidarModel model_;
  LoamSettings settings_;
  double step_rad_;
  SweepOrder order_;
  KeyFrameSelector key_frames_;
  LoamMap map_;
  bool started_ = false;
  std::optional<LoamFeatures> first_;  ///< of the first sweep, till its motion is known
  LoamMotion motion_;
  double usual_share_ = 0.0;      ///< of edges close to their line
  std::int64_t lost_sweeps_ = 0;  ///< without a registration, in a row
  double coasted_periods_ = 0.0;  ///< revolutions since the last registration
  LoamRegistration last_registration_;
  OdometryEstimate last_;
};

}  // namespace honka
