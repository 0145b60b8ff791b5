#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "algo/localize/matcher.h"
#include "algo/localize/tracking/drift_filter.h"

namespace honka {

/// What a track is doing.
enum class TrackState : std::uint8_t {
  kSearching,  ///< no pose yet
  kTracking,   ///< a localization supported it lately
  kCoasting,   ///< odometry alone for longer than `coasting_after_s`
  kLost,       ///< given up; no pose until localizations agree with one another
};

/// searching | tracking | coasting | lost
[[nodiscard]] std::string_view name_of(TrackState state);

/// Something that a user of the track must know.
struct TrackEvent {
  enum class Kind : std::uint8_t {
    kInitialised,  ///< the first localizations agree: the track begins
    kCoasting,     ///< no localization for too long
    kLost,         ///< localizations contradict the track, and one another
    kKidnapped,    ///< localizations agree on a place that the odometry cannot have led to;
                   ///< `recovered` follows at the same time
    kRecovered,    ///< the track runs again after coasting, loss or kidnapping
  };
  double time_s = 0.0;
  Kind kind = Kind::kInitialised;
  double distance_m = 0.0;  ///< kidnapped, recovered: from where the track was before
};

/// initialised | coasting | lost | kidnapped | recovered
[[nodiscard]] std::string_view name_of(TrackEvent::Kind kind);

/// A pose of the track; a pose and a covariance only where `has_pose`.
struct TrackedPose {
  double time_s = 0.0;
  TrackState state = TrackState::kSearching;
  Belief belief;
  double since_fix_s = 0.0;  ///< since the last localization that was used

  [[nodiscard]] bool has_pose() const {
    return state == TrackState::kTracking || state == TrackState::kCoasting;
  }
};

/// An accepted localization, and the odometry's pose of the frame that it answers for.
struct TrackFix {
  double time_s = 0.0;
  Pose2 T_odom_lidar;
  Pose2 T_map_local;
  std::optional<Eigen::Matrix3d> covariance;  ///< LocateResult::covariance
};

/// What became of a fix.
enum class FixUse : std::uint8_t {
  kUsed,      ///< inside the gate: the track took it
  kRejected,  ///< outside the gate: remembered against the track
  kHeld,      ///< no track: remembered until others agree
  kRestart,   ///< completed the agreement that began, moved or recovered the track
  kRefused,   ///< not finite, or its covariance is none
};

/// used | rejected | held | restart | refused
[[nodiscard]] std::string_view name_of(FixUse use);

/// A pose at every scan from odometry and from localizations that come now and then: an error-state
/// Kalman filter on SE(2) and the odometry's drift, with rivals. A fix outside the gate founds a
/// rival, or joins one that it agrees with; a rival of `confirm_fixes` becomes the track.
class PoseTracker {
 public:
  /// Throws UserError at settings outside of what `describe` allows.
  explicit PoseTracker(const TrackingSettings& settings);

  /// The odometry's pose at a scan, in the order of time → the track's. `covariance`: what the
  /// odometry states of that registration, of (x, y, yaw) along the lidar's axes. Throws UserError
  /// at a time that runs backwards, a number not finite or a covariance that is none.
  TrackedPose add_odometry(double time_s, const Pose2& T_odom_lidar,
                           const std::optional<Eigen::Matrix3d>& covariance = std::nullopt);

  /// A localization that was accepted, at or before the last scan; it is carried to it by the
  /// odometry. Throws UserError before the first scan.
  FixUse add_fix(const TrackFix& fix);

  /// A localization that was refused: counts against searching near the track alone.
  void add_miss() { ++misses_; }

  /// Where the next localization need search: within 3 s.d. of the track and a floor. Nothing while
  /// there is no track, and after `prior_misses` refusals or rejections in a row: then the whole
  /// map is asked, or a kidnapping could not be seen.
  [[nodiscard]] std::optional<LocatePrior> prior() const;

  [[nodiscard]] TrackedPose pose() const;
  [[nodiscard]] const std::vector<TrackEvent>& events() const { return events_; }

 private:
  /// Fixes that agree with one another and not with the track.
  struct Rival {
    DriftFilter filter;
    std::int64_t fixes = 0;
    double travelled_m = 0.0;  ///< where its last counted fix was
  };

  [[nodiscard]] Belief carried(const TrackFix& fix) const;
  [[nodiscard]] Belief weakened(const Belief& fix) const;
  void use(const Belief& fix, double fix_time_s);
  FixUse remember(const Belief& fix);
  [[nodiscard]] Rival* agreeing_rival(const Belief& fix);
  void restart(const DriftFilter& filter);
  void report(TrackEvent::Kind kind, double distance_m = 0.0);

  TrackingSettings settings_;
  double gate_ = 0.0;
  std::optional<Pose2> T_odom_last_;
  std::optional<Eigen::Matrix3d> covariance_last_;
  double time_s_ = 0.0;
  double travelled_m_ = 0.0;
  TrackState state_ = TrackState::kSearching;
  std::optional<DriftFilter> track_;  ///< the last one, moved on by odometry, while lost
  double last_fix_s_ = 0.0;
  double last_fix_travelled_m_ = 0.0;
  std::int64_t rejected_in_a_row_ = 0;
  std::int64_t misses_ = 0;
  std::vector<Rival> rivals_;  ///< the oldest first
  std::vector<TrackEvent> events_;
};

}  // namespace honka
