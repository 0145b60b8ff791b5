#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algo/odometry/loam/settings.h"
#include "algo/odometry/stems/settings.h"
#include "algo/types/lidar_model.h"
#include "algo/types/pose.h"
#include "algo/types/settings.h"
#include "algo/types/sweep.h"

namespace honka {

/// What became of a sweep.
enum class OdometryStatus : std::uint8_t {
  kRegistered,  ///< every direction was observed
  kDegenerate,  ///< registered; directions that the scan does not observe follow the prediction
  kPredicted,   ///< not registered: constant velocity from the last sweeps
  kRefused,     ///< the sweep cannot be placed in time; its pose is the last one
};

/// Why a sweep was not plainly registered.
enum class OdometryCause : std::uint8_t {
  kNone,
  kGap,           ///< sweeps are missing before this one
  kRepeatedTime,  ///< starts when the last one started
  kReversedTime,  ///< starts before the last one
  kNotFinite,     ///< times or azimuth are no numbers
  kEmptyScan,     ///< holds no usable return
  kFewFeatures,   ///< too few to register
  kUnobserved,    ///< a direction is not observed
  kNotConverged,  ///< the registration came to no rest
  kJump,          ///< the registration contradicts what a machine can do since the last sweep
};

/// registered | degenerate | predicted | refused
[[nodiscard]] std::string_view name_of(OdometryStatus status);
/// none | gap | repeated_time | …
[[nodiscard]] std::string_view name_of(OdometryCause cause);

using Covariance6 = Eigen::Matrix<double, 6, 6>;

/// m², rad²: OdometryEstimate::covariance of what is not observed.
inline constexpr double kUnobservedVariance = 1e3;

/// The motion of the lidar during one sweep.
struct OdometryEstimate {
  std::int64_t sweep = 0;                  ///< Sweep::index
  double start_time_s = 0.0;               ///< of the first firing
  double end_time_s = 0.0;                 ///< one revolution later
  Pose3 T_odom_start = Pose3::Identity();  ///< T_odom_lidar at start_time_s
  Pose3 T_odom_end = Pose3::Identity();    ///< at end_time_s; constant body twist between
  /// Of the registration of this sweep, as a twist (translation, then rotation vector) in the frame
  /// of the lidar at the sweep's end: T exp(ξ). What the reference of the registration has drifted
  /// is not in it. At least kUnobservedVariance in directions that were not observed.
  Covariance6 covariance = Covariance6::Identity();
  OdometryStatus status = OdometryStatus::kRegistered;
  OdometryCause cause = OdometryCause::kNone;
};

/// The covariance of an estimate's registration, of (x, y, yaw) of the levelled lidar along its own
/// axes at the sweep's end. m², rad².
[[nodiscard]] Eigen::Matrix3d planar_covariance(const OdometryEstimate& estimate);

/// Estimates the way of a lidar from its scans. Its frame, odom, has its origin where the lidar is
/// at the first sweep's start, x along its heading there, and z up.
class Odometry {
 public:
  virtual ~Odometry() = default;
  /// Takes the sweeps in the order of time, one call each. Never throws for what a sweep holds and
  /// never answers a pose that is not finite: the status says what happened.
  [[nodiscard]] virtual OdometryEstimate process(const Sweep& sweep) = 0;
  /// Whether `process` looks at the returns; where not, a sweep's index and times are enough.
  [[nodiscard]] virtual bool needs_returns() const { return true; }
};

/// Settings of every lidar odometry; keys `odometry.<name>.*`.
struct LidarOdometrySettings {
  LoamSettings loam;
  StemOdometrySettings stems;
};
void describe(SettingsVisitor& v, LidarOdometrySettings& s);

/// Names that `create_odometry` knows.
[[nodiscard]] const std::vector<std::string>& odometry_names();

/// A new odometry at its start. UserError with the known names for any other.
[[nodiscard]] std::unique_ptr<Odometry> create_odometry(std::string_view name,
                                                        const LidarModel& model,
                                                        const LidarOdometrySettings& settings);

}  // namespace honka
