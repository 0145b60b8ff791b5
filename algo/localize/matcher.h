#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algo/localize/consensus/settings.h"
#include "algo/localize/li2020/settings.h"
#include "algo/types/pose.h"
#include "algo/types/settings.h"

namespace honka {

/// What a matcher says of a local stem list.
enum class Verdict : std::uint8_t {
  kAccepted,     ///< the pose can be used
  kAmbiguous,    ///< two poses explain the stems about as well
  kNotInMap,     ///< too little of the local graph was found in the map
  kTooFewStems,  ///< the local list holds nothing that could be matched
};

/// accepted | ambiguous | not_in_map | too_few_stems
[[nodiscard]] std::string_view verdict_name(Verdict verdict);

/// A local stem and the map stem it was paired with, as indices of the lists that were given.
struct VertexPair {
  std::int32_t local = -1;
  std::int32_t map = -1;

  bool operator==(const VertexPair&) const = default;
};

/// One local triangle star found in the map (Li2020 §2.8). Triangle indices are those of
/// `build_delaunay` of the lists that were given.
struct StarMatch {
  std::int32_t local_triangle = -1;   ///< centre of the local star
  std::int32_t map_triangle = -1;     ///< centre of the map star
  int rotation = 0;                   ///< local neighbour k looks like map neighbour (k + r) mod 3
  double dissimilarity_m2 = 0.0;      ///< sum over the centre and its three neighbours
  std::array<VertexPair, 6> pairs{};  ///< three corners, three apexes; possibly 5 distinct
  double theta_rad = 0.0;             ///< Li2020 Eq. (3)
  Eigen::Vector2d printed_translation_m = Eigen::Vector2d::Zero();  ///< p_t as Eq. (3) prints it
  Eigen::Vector2d translation_m = Eigen::Vector2d::Zero();  ///< t = V̄' − R V̄, "rotate, then move"
  double cost_m = 0.0;      ///< sum of the six residuals under (theta, t)
  double residual_m = 0.0;  ///< mean of the six residuals under the answered pose
  bool agrees = false;      ///< residual_m is below the agreement
};

/// What else is known of the place of the sensor, from GNSS or from the last pose.
struct LocatePrior {
  Eigen::Vector2d position_in_map_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;  ///< the sensor is within this of the position; an answer never is not
};

/// Throws UserError at a position not finite or a radius not positive.
void check_prior(const std::optional<LocatePrior>& prior);

/// The answer for one local stem list.
struct LocateResult {
  Verdict verdict = Verdict::kTooFewStems;
  Pose2 T_map_local;  ///< best guess, also when refused; the identity when nothing matched
  /// The same with height and tilt; T_map_local is its plan. Of matchers that ask for heights,
  /// where anything matched.
  std::optional<Pose3> T_map_local_3d;
  int stems = 0;        ///< in the local list
  int local_stars = 0;  ///< stars that were looked for
  int candidates = 0;   ///< pairs of local and map stars within the tolerance
  int matches = 0;      ///< local stars with a map star
  int agreeing = 0;     ///< matches that agree with the pose
  int inliers = 0;      ///< distinct local stems in agreeing matches
  /// li2020: agreeing / matches; consensus: nats over chance and over every other place. 0 without
  /// a match.
  double margin = 0.0;
  /// Of (x, y, yaw) in the map frame, m² and rad², from the residuals of the pairs; of accepted
  /// poses, by matchers that estimate it.
  std::optional<Eigen::Matrix3d> covariance;
  /// The listed stems lie so much nearer to the sensor than those of the map, which the pose makes
  /// up for; 0 where none was certain.
  double radial_bias_m = 0.0;
  /// (xx, yy, xy) along the sensor's axes by which the list was stretched onto the map, because it
  /// was not levelled; 0 where none was certain.
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  double cost_m = 0.0;                  ///< Li2020 Eq. (4) at the pose
  int chosen = -1;                      ///< index into star_matches of the pose's match
  std::vector<StarMatch> star_matches;  ///< in the order of local triangles, for figures

  [[nodiscard]] bool accepted() const { return verdict == Verdict::kAccepted; }
};

/// Finds the pose of local stem lists in one map, without an initial guess.
class Matcher {
 public:
  virtual ~Matcher() = default;

  /// N stems seen from the sensor (the local origin), metres → pose of the sensor in the map; with
  /// a prior, among the places it allows. Any number of stems is an answerable question. Throws
  /// UserError at a coordinate not finite or a radius not positive. Safe to call from several
  /// threads.
  /// UserError, too, from a matcher that asks for heights. One that does not overrides this alone.
  [[nodiscard]] virtual LocateResult locate(const std::vector<Eigen::Vector2d>& stems_in_local_m,
                                            const std::optional<LocatePrior>& prior) const;

  /// The same of N stems with heights: where each stands, x, y, z from the sensor along its axes,
  /// which may be tilted. A matcher in the plane leaves z out. UserError at a height not finite.
  [[nodiscard]] virtual LocateResult locate(const std::vector<Eigen::Vector3d>& stems_in_local_m,
                                            const std::optional<LocatePrior>& prior) const;

  /// Without a prior.
  [[nodiscard]] LocateResult locate(const std::vector<Eigen::Vector2d>& stems_in_local_m) const {
    return locate(stems_in_local_m, std::nullopt);
  }
  [[nodiscard]] LocateResult locate(const std::vector<Eigen::Vector3d>& stems_in_local_m) const {
    return locate(stems_in_local_m, std::nullopt);
  }
};

/// x and y of N stems with heights. UserError at a height that is not finite.
[[nodiscard]] std::vector<Eigen::Vector2d> plan_of(const std::vector<Eigen::Vector3d>& stems_m);

/// Everything a scenario can say about localization.
struct LocalizeSettings {
  std::string method = "li2020";
  Li2020Settings li2020;
  ConsensusSettings consensus;
};

void describe(SettingsVisitor& v, LocalizeSettings& s);

/// The registered matchers, in the order of registration.
[[nodiscard]] const std::vector<std::string>& matcher_names();

/// The matcher `method` for a map of N stems (metres; UTM-sized coordinates keep millimetres).
/// Throws UserError at an unknown method, a coordinate not finite, settings that ask for heights,
/// or a map that cannot be matched.
[[nodiscard]] std::unique_ptr<Matcher> create_matcher(
    std::string_view method, const std::vector<Eigen::Vector2d>& stems_in_map_m,
    const LocalizeSettings& settings);

/// The same for a map of N stems with heights, z up. Where the settings do not ask for heights they
/// are left out.
[[nodiscard]] std::unique_ptr<Matcher> create_matcher(
    std::string_view method, const std::vector<Eigen::Vector3d>& stems_in_map_m,
    const LocalizeSettings& settings);

}  // namespace honka
