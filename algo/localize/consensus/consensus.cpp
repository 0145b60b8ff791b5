#include "algo/localize/consensus/consensus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algo/localize/consensus/allowed.h"
#include "algo/localize/consensus/exhaustive_search.h"
#include "algo/localize/consensus/frame.h"
#include "algo/localize/consensus/group_search.h"
#include "algo/localize/consensus/judge.h"
#include "algo/localize/consensus/places.h"
#include "algo/localize/consensus/pose_estimate.h"
#include "algo/localize/consensus/twins.h"
#include "algo/types/user_error.h"

namespace honka {
namespace {

constexpr double kNarrowest_m = 0.5;  // stems nearer to a line than this tell no mirror image apart

/// From groups; where these leave a doubt, from all turns and shifts.
PlaceList find_places(const Judge& judge, const LocalFrame& frame, const Allowed& allowed,
                      LocateResult& result) {
  PlaceList places;
  const double accept = judge.settings().accept_nats;
  result.candidates = static_cast<int>(search_groups(judge, frame, allowed, places));
  if (!places.empty() && places.margin_nats(accept) >= accept) return places;
  const StemGrid& grid = judge.index().grid();
  search_exhaustively(judge, frame, allowed.stems(grid, frame.radius_m()), allowed, places);
  if (!places.empty()) add_twins(judge, Fit(*places.best()), allowed, places);
  return places;
}

}  // namespace

ConsensusMatcher::ConsensusMatcher(std::shared_ptr<const ConsensusIndex> index,
                                   ConsensusSettings settings)
    : index_(std::move(index)), settings_(settings) {
  const auto require = [](bool holds, const char* line) {
    if (!holds) throw UserError(line);
  };
  require(settings_.stem_sigma_m > 0.0 && settings_.stem_sigma_m <= 0.5,
          "consensus.stem_sigma_m must be above 0 and at most 0.5");
  require(settings_.sigma_floor_m > 0.0 && settings_.sigma_floor_m <= 0.5,
          "consensus.sigma_floor_m must be above 0 and at most 0.5");
  require(settings_.accept_nats >= 0.0 && std::isfinite(settings_.accept_nats),
          "consensus.accept_nats must not be negative");
  require(settings_.least_share >= 0.0 && settings_.least_share <= 1.0,
          "consensus.least_share must be from 0 to 1");
  require(settings_.radial_bias_sds >= 0.0, "consensus.radial_bias_sds must not be negative");
  require(settings_.exhaustive_votes >= 0.0, "consensus.exhaustive_votes must not be negative");
}

LocateResult ConsensusMatcher::locate(const std::vector<Eigen::Vector2d>& stems_in_local_m,
                                      const std::optional<LocatePrior>& prior) const {
  check_prior(prior);
  LocateResult result;
  result.stems = static_cast<int>(stems_in_local_m.size());

  // The frame, and whether it could be told from chance at all
  const LocalFrame frame = make_frame(stems_in_local_m);
  if (frame.stems_m.size() < 3 || frame.width_m() < kNarrowest_m) return result;
  const Allowed allowed(prior, -frame.middle_m, index_->centre_m());
  const Judge judge(*index_, settings_, frame.stems_m, allowed.area_m2(index_->grid()));
  if (!judge.could_accept()) return result;

  // Places, weighed
  const PlaceList places = find_places(judge, frame, allowed, result);
  result.verdict = Verdict::kNotInMap;
  result.matches = static_cast<int>(places.size());
  if (places.empty()) return result;

  // The best of them
  constexpr int kToTheEnd = 50;
  const Fit best = judge.settle(*places.best(), kToTheEnd);
  result.inliers = result.agreeing = best.inliers;
  result.margin = places.margin_nats(settings_.accept_nats);
  result.T_map_local = {best.placement * allowed.sensor_in_frame_m() + index_->centre_m(),
                        best.placement.yaw_rad()};
  const double seen = static_cast<double>(frame.stems_m.size());
  const bool most_agree = best.inliers > settings_.least_share * seen;
  if (best.evidence_nats < settings_.accept_nats || !most_agree) return result;

  // Its pose, and the verdict
  const auto estimate = estimate_pose(judge, allowed.sensor_in_frame_m(), best);
  if (!estimate || !allowed.holds(estimate->T_map_sensor.shift_m)) return result;
  result.T_map_local = {estimate->T_map_sensor.shift_m + index_->centre_m(),
                        estimate->T_map_sensor.yaw_rad()};
  result.verdict =
      result.margin >= settings_.accept_nats ? Verdict::kAccepted : Verdict::kAmbiguous;
  if (!result.accepted()) return result;
  result.covariance = estimate->covariance;
  result.radial_bias_m = estimate->radial_bias_m;
  result.strain = estimate->strain;
  return result;
}

}  // namespace honka
