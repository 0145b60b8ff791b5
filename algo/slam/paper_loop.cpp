#include "algo/slam/paper_loop.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "algo/slam/chain.h"
#include "algo/slam/correction/order.h"
#include "algo/slam/correction/poisson_choice.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/map_quality/live_map.h"
#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& total_s) : total_s_(total_s) {}
  ~Stopwatch() {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    total_s_ += spent.count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// e of each chain step; a step that cannot be judged counts as the worst that can.
std::vector<double> step_errors(std::span<const SparseFrame> frames, const FramePoses& poses,
                                const ViewCone& cone, const MatchQualitySettings& quality) {
  std::vector<double> errors;
  double worst = 0.0;
  for (std::size_t l = 0; l + 1 < frames.size(); ++l) {
    errors.push_back(judge_match(frames[l].points_m, frames[l + 1].points_m,
                                 between(poses, l, l + 1), cone, quality)
                         .error_m);
    if (std::isfinite(errors.back())) worst = std::max(worst, errors.back());
  }
  for (double& error : errors) error = std::isfinite(error) ? error : worst;
  return errors;
}

/// One run of the loop: the map as it stands, and the steps that a pair goes through.
class PaperLoop {
 public:
  PaperLoop(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
            const ViewCone& cone, const PaperLoopSettings& settings)
      : frames_(frames),
        cone_(cone),
        overlap_(cone),
        settings_(settings),
        map_(frames, T_first_frame, settings.blur) {
    result_.blur_before = map_.blur();
    remember_best();
  }

  /// The pairs of a round, in the order in which they are applied.
  [[nodiscard]] std::vector<FramePair> choose_pairs(std::uint64_t seed) {
    const CandidatePairs found = find_candidate_pairs(
        frames_, map_.poses(), cone_, settings_.quality, settings_.icp, settings_.pairs, seed);
    const PoissonChoice choice = choose_near_poisson(found.promising, settings_.corrections);
    std::vector<FramePair> chosen, ordered;
    for (const std::size_t k : choice.chosen) chosen.push_back(found.promising[k]);
    for (const std::size_t k : order_corrections(chosen, correction_order(settings_.order), seed)) {
      ordered.push_back(chosen[k]);
    }
    result_.pairs_tried += found.tried;
    result_.candidates += static_cast<std::int64_t>(found.promising.size());
    result_.chosen += static_cast<std::int64_t>(chosen.size());
    if (settings_.coefficient == "errors") {
      step_errors_m_ = step_errors(frames_, map_.poses(), cone_, settings_.quality);
    }
    return ordered;
  }

  /// Registers a pair and, where that holds, lays the map on it.
  [[nodiscard]] CorrectionReport correct(const FramePair& pair) {
    CorrectionReport report;
    report.pair = pair;
    const Pose3 T_j_i = match(report);
    if (report.outcome == CorrectionOutcome::kApplied) report.outcome = accepted(report);
    if (report.outcome == CorrectionOutcome::kApplied) update(report, T_j_i);
    report.blur = map_.blur();
    remember_best();
    return report;
  }

  [[nodiscard]] bool stalled() const {
    return settings_.patience > 0 && since_best_ >= settings_.patience;
  }

  [[nodiscard]] const FramePoses& poses() const { return map_.poses(); }

  [[nodiscard]] PaperLoopResult finish() {
    result_.ended_early = stalled();
    result_.T_first_frame = result_.ended_early ? best_ : map_.poses();
    result_.blur = result_.ended_early ? best_blur_ : map_.blur();
    return result_;
  }

 private:
  /// Trimmed ICP first; Go-ICP where its match does not meet Eq. 27. Sets what the report says of
  /// the match: kApplied stands for one that may be used.
  [[nodiscard]] Pose3 match(CorrectionReport& report) {
    const auto& target_m = frames_[report.pair.j].points_m;
    const auto& source_m = frames_[report.pair.i].points_m;
    const Pose3 T_guess = between(map_.poses(), report.pair.j, report.pair.i);
    const Registration icp = [&] {
      const Stopwatch watch(result_.icp_s);
      ++result_.icp_calls;
      return trimmed_icp(target_m, source_m, T_guess, settings_.icp);
    }();
    report.error_before_m = error_of(report.pair, T_guess);
    judge(report, icp.T_target_source);
    // Nevalainen2021 Eq. (27)
    const bool fits = icp.usable() && report.overlap > settings_.pairs.overlap_limit &&
                      report.error_m < settings_.pairs.error_limit_m(report.overlap);
    if (fits || !settings_.use_go_icp) {
      report.outcome = fits ? outcome_of_overlap(report) : CorrectionOutcome::kNotRegistered;
      return icp.T_target_source;
    }
    const Registration go = [&] {
      const Stopwatch watch(result_.go_icp_s);
      ++result_.go_icp_calls;
      return go_icp(target_m, source_m, T_guess, settings_.go_icp, cone_);
    }();
    report.used_go_icp = true;
    judge(report, go.T_target_source);
    report.outcome = go.usable() ? outcome_of_overlap(report) : CorrectionOutcome::kNotRegistered;
    return go.T_target_source;
  }

  void judge(CorrectionReport& report, const Pose3& T_j_i) const {
    report.overlap = overlap_(T_j_i);
    report.error_m = error_of(report.pair, T_j_i);
  }

  [[nodiscard]] double error_of(const FramePair& pair, const Pose3& T_j_i) const {
    return judge_match(frames_[pair.j].points_m, frames_[pair.i].points_m, T_j_i, cone_,
                       settings_.quality)
        .error_m;
  }

  [[nodiscard]] CorrectionOutcome outcome_of_overlap(const CorrectionReport& report) const {
    return report.overlap < settings_.match_overlap_limit ? CorrectionOutcome::kTooLittleOverlap
                                                          : CorrectionOutcome::kApplied;
  }

  [[nodiscard]] CorrectionOutcome accepted(const CorrectionReport& report) const {
    const bool asked = settings_.acceptance == "error_falls";
    return asked && !(report.error_m < report.error_before_m) ? CorrectionOutcome::kErrorDidNotFall
                                                              : CorrectionOutcome::kApplied;
  }

  /// Lays the map on the match; takes it back where β says so.
  void update(CorrectionReport& report, const Pose3& T_j_i) {
    const std::size_t j = report.pair.j, i = report.pair.i;
    const std::vector<double> shares =
        power_coefficients(map_.poses(), j, i, power_coefficient(settings_.coefficient),
                           step_errors_m_, settings_.metric);
    FramePoses before = map_.poses();
    const double blur_before = map_.blur();
    FramePoses after = before;
    apply_correction(after, {j, i, T_j_i}, shares, update_side(settings_.side));
    map_.move_after(j, std::move(after));
    if (settings_.acceptance == "blur_falls" && !(map_.blur() < blur_before)) {
      report.outcome = CorrectionOutcome::kBlurDidNotFall;
    } else if (settings_.max_blur_rise > 0.0 &&
               map_.blur() > (1.0 + settings_.max_blur_rise) * blur_before) {
      report.outcome = CorrectionOutcome::kStoppedByBlurGuard;
    }
    if (report.outcome == CorrectionOutcome::kApplied) {
      ++result_.applied;
    } else {
      map_.move_after(j, std::move(before));
    }
  }

  void remember_best() {
    ++since_best_;
    if (!(map_.blur() < best_blur_) && !best_.empty()) return;
    since_best_ = 0;
    best_blur_ = map_.blur();
    best_ = map_.poses();
  }

  std::span<const SparseFrame> frames_;
  const ViewCone& cone_;
  ViewOverlap overlap_;
  const PaperLoopSettings& settings_;
  LiveMap map_;
  std::vector<double> step_errors_m_;
  FramePoses best_;
  double best_blur_ = std::numeric_limits<double>::infinity();
  std::int64_t since_best_ = 0;
  PaperLoopResult result_;
};

}  // namespace

PaperLoopResult run_paper_loop(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
                               const ViewCone& cone, const PaperLoopSettings& settings,
                               std::uint64_t seed, const CorrectionObserver& observer) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  PaperLoop loop(frames, T_first_frame, cone, settings);
  std::int64_t number = 0;
  for (std::int64_t round = 0; round < settings.rounds && !loop.stalled(); ++round) {
    const std::uint64_t round_seed =
        derive_seed(seed, "paper_loop", {static_cast<std::uint64_t>(round)});
    for (const FramePair& pair : loop.choose_pairs(round_seed)) {
      CorrectionReport report = loop.correct(pair);
      report.round = round;
      report.number = number++;
      if (observer) observer(report, loop.poses());
      if (loop.stalled()) break;
    }
  }
  return loop.finish();
}

}  // namespace honka
