#include "eval/run/slam/selection_trial.h"

#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/slam/chain.h"

namespace honka::eval {
namespace {

/// Counts what the truth says of the pairs of a case.
class PairTruth {
 public:
  PairTruth(const ImprovementStart& start, const SlamSettings& settings, SelectionCase& c)
      : start_(start), settings_(settings), case_(c) {}

  void count(const std::vector<FramePair>& pairs, std::int64_t& right) const {
    for (const FramePair& pair : pairs) {
      const Pose3 T_true = between(start_.drive.true_T_first_frame, pair.j, pair.i);
      const Pose3 error = T_true.inverse() * judged_motion(pair);
      const double turn_deg = so3_log(error.linear()).norm() * 180.0 / M_PI;
      if (error.translation().norm() < kRightPair_m && turn_deg < kRightPair_deg) ++right;
      if (under_line(pair, T_true)) ++case_.under_line_at_truth;
    }
  }

 private:
  /// Where the test judged the pair.
  [[nodiscard]] Pose3 judged_motion(const FramePair& pair) const {
    const Pose3 T_j_i = between(start_.T_first_frame, pair.j, pair.i);
    if (case_.test != "icp") return T_j_i;
    return trimmed_icp(points(pair.j), points(pair.i), T_j_i, settings_.loop.icp).T_target_source;
  }

  [[nodiscard]] bool under_line(const FramePair& pair, const Pose3& T_j_i) const {
    const double error_m =
        judge_match(points(pair.j), points(pair.i), T_j_i, settings_.view, settings_.loop.quality)
            .error_m;
    return error_m < settings_.loop.pairs.error_limit_m(view_overlap(T_j_i, settings_.view));
  }

  [[nodiscard]] const std::vector<Eigen::Vector3d>& points(std::size_t frame) const {
    return start_.drive.frames[frame].points_m;
  }

  const ImprovementStart& start_;
  const SlamSettings& settings_;
  SelectionCase& case_;
};

}  // namespace

std::vector<SelectionCase> run_selection(const ImprovementStart& start,
                                         const SlamSettings& settings, std::int64_t trial) {
  std::vector<SelectionCase> cases;
  for (const std::string test : {"nearest", "icp"}) {
    CandidatePairSettings pairs = settings.loop.pairs;
    pairs.test = test;
    SelectionCase c;
    c.trial = trial;
    c.test = test;
    c.frames = start.drive.frames.size();
    c.found = find_candidate_pairs(start.drive.frames, start.T_first_frame, settings.view,
                                   settings.loop.quality, settings.loop.icp, pairs, start.seed);
    c.choice = choose_near_poisson(c.found.promising, settings.loop.corrections);
    c.overlap_limit = pairs.overlap_limit;
    c.error_at_no_overlap_m = pairs.error_at_no_overlap_m;
    c.error_slope_m = pairs.error_slope_m;
    const PairTruth truth(start, settings, c);
    truth.count(c.found.promising, c.promising_right);
    truth.count(c.found.inferior, c.inferior_right);
    cases.push_back(std::move(c));
  }
  return cases;
}

}  // namespace honka::eval
