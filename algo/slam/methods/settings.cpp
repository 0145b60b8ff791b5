#include "algo/slam/correction/order.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/methods/interpolate_pairs.h"
#include "algo/slam/methods/landmark_ba.h"
#include "algo/slam/methods/pose_graph.h"
#include "algo/slam/methods/rechain.h"
#include "algo/slam/methods/stem_map.h"
#include "algo/slam/methods/verified_pairs.h"

namespace honka {

void describe(SettingsVisitor& v, RechainSettings& s) {
  v.field({"inlier_ratio", "", "part of the points that trimmed ICP fits", "Nevalainen2021 §2.3"},
          s.inlier_ratio, Range{0.01, 1.0});
  v.field({"polish_distance_m", "m", "planar pairs nearer than this are all fitted at last",
           "choice: some six times the noise of a stem"},
          s.polish_distance_m, Range{0.01, 10.0});
  v.field({"min_share", "", "of the common view's points with a partner, or the step is no match",
           "choice: true steps have over 0.55, wrong ones under 0.25"},
          s.min_share, Range{0.0, 1.0});
  v.field({"search_distance_m", "m", "half side of the search around the prediction",
           "choice: what a machine moves while its cabin turns"},
          s.search_distance_m, Range{0.0, 100.0});
  v.field({"search_turn_deg", "deg", "headings tried, either way", "choice: as above"},
          s.search_turn_deg, Range{0.0, 180.0});
  v.field({"search_step_m", "m", "of the search's lattice",
           "choice: below the convergence limit of ICP, half the distance of stems"},
          s.search_step_m, Range{0.05, 10.0});
  v.field({"search_step_deg", "deg", "of the search's headings", "choice: as above"},
          s.search_step_deg, Range{0.1, 90.0});
}

void describe(SettingsVisitor& v, VerifiedPairsSettings& s) {
  v.field({"gaps", "", "frames between the two of a pair, a scale each, the finest first",
           "choice: factors of four"},
          s.gaps, Range{1.0, 1e6});
  v.field({"share_of_frames", "", "pairs tried, of the number of frames; at most one more a scale",
           "Nevalainen2021, abstract: 4 %"},
          s.share_of_frames, Range{0.0, 10.0});
  v.field({"min_overlap", "", "least overlap of the view cones by the current poses",
           "choice: near Nevalainen2021 §2.3, 0.4"},
          s.min_overlap, Range{0.0, 1.0});
  v.field({"inlier_ratio", "", "part of the points that trimmed ICP fits",
           "choice: at 0.7 half of the wide pairs fail"},
          s.inlier_ratio, Range{0.01, 1.0});
  v.field({"polish_distance_m", "m", "planar pairs nearer than this are all fitted at last",
           "choice: some six times the noise of a stem"},
          s.polish_distance_m, Range{0.01, 10.0});
  v.field({"min_match_share", "", "of the common view's points with a partner, or it is no match",
           "choice: true pairs have 0.33–0.74, wrong ones under 0.05"},
          s.min_match_share, Range{0.0, 1.0});
  v.field({"global", "", "registration where ICP fails the share test", "choice"}, s.global,
          {"landmarks", "go_icp", "none"});
  v.field({"propose", "", "also look for pairs without trusting the poses", "choice"}, s.propose);
  v.field({"proposal_step", "", "frames between those that look for each other", "choice"},
          s.proposal_step, Range{1.0, 1e6});
  v.field(
      {"proposal_points", "", "points in the common view that a proposed match needs", "choice"},
      s.proposal_points, Range{3.0, 1e6});
  v.field({"proposal_share", "", "of them with a partner, or the proposal is no match", "choice"},
          s.proposal_share, Range{0.0, 1.0});
}

void describe(SettingsVisitor& v, InterpolatePairsSettings& s) {
  v.field({"side", "", "where the share of a correction acts: in frame l, or in frame j",
           "Nevalainen2021 Eq. (19) prints right; left has the same ends and no turned axes"},
          s.side, update_side_names());
  v.field({"order", "", "of the matches", "choice"}, s.order, correction_order_names());
}

void describe(SettingsVisitor& v, PoseGraphSettings& s) {
  v.field({"chain_m", "m", "standard deviation of a step of the chain",
           "choice: twice what re-registered steps have"},
          s.chain_m, Range{1e-6, 1e3});
  v.field({"chain_deg", "deg", "the same of its rotation", "choice"}, s.chain_deg,
          Range{1e-6, 180.0});
  v.field({"match_m", "m", "standard deviation of a corrective match", "choice"}, s.match_m,
          Range{1e-6, 1e3});
  v.field({"match_deg", "deg", "the same of its rotation", "choice"}, s.match_deg,
          Range{1e-6, 180.0});
  v.field({"bad_step_factor", "", "on both where a step failed its share test", "choice"},
          s.bad_step_factor, Range{1.0, 1e6});
  v.field(
      {"robust_scale", "", "standard deviations where the matches' loss bends; 0: none", "choice"},
      s.robust_scale, Range{0.0, 1e6});
  v.field({"max_iterations", "", "Levenberg–Marquardt steps at most", "choice"}, s.max_iterations,
          Range{1.0, 1e4});
}

void describe(SettingsVisitor& v, StemMapSettings& s) {
  v.field({"gate_m", "m", "an observation belongs to a stem nearer than this",
           "choice: below the distance of stems, above the errors of poses"},
          s.gate_m, Range{0.05, 0.8});
  v.field({"min_observations", "", "frames that must see a stem", "choice"}, s.min_observations,
          Range{1.0, 1e6});
}

void describe(SettingsVisitor& v, LandmarkBaSettings& s) {
  v.field({"planar_m", "m", "standard deviation of an observation in x and in y",
           "choice: Nevalainen2021 §2.3 has 0.05–0.10"},
          s.planar_m, Range{1e-6, 1e3});
  v.field({"vertical_m", "m", "the same in z", "choice"}, s.vertical_m, Range{1e-6, 1e3});
  v.field({"robust_scale", "", "standard deviations where the loss bends; 0: none", "choice"},
          s.robust_scale, Range{0.0, 1e6});
  v.field({"chain_m", "m", "standard deviation of the tie between neighbours",
           "choice: weak; it holds the frames that no stem holds"},
          s.chain_m, Range{1e-6, 1e3});
  v.field({"chain_deg", "deg", "the same of its rotation", "choice"}, s.chain_deg,
          Range{1e-6, 180.0});
  v.field({"rounds", "", "associations of observations with stems", "choice"}, s.rounds,
          Range{0.0, 100.0});
  v.field({"iterations", "", "Gauss–Newton steps of a round at most", "choice"}, s.iterations,
          Range{1.0, 100.0});
}

}  // namespace honka
