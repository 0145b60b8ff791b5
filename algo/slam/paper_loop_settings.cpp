#include "algo/slam/correction/order.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/paper_loop.h"
#include "algo/types/check.h"

namespace honka {

GoIcpSettings paper_go_icp() {
  GoIcpSettings settings;
  settings.mode = "l0";
  settings.time_cap_s = 0.0;
  settings.node_cap = 100000;
  return settings;
}

// Not in the header: g++ 12 takes the texts for uninitialized where it inlines all the defaults.
PaperLoopSettings::PaperLoopSettings() = default;

void describe(SettingsVisitor& v, PaperLoopSettings& s) {
  v.group("pairs", [&] { describe(v, s.pairs); });
  v.field({"corrections", "", "pairs chosen in a round, nearly", "Nevalainen2021 §2.4: m ≈ 100"},
          s.corrections, Range{0.0, 1e6});
  v.field({"order", "", "in which the chosen pairs are applied", "Nevalainen2021 §3, Table 1"},
          s.order, correction_order_names());
  v.field({"coefficient", "", "how a correction is spread over the frames between its ends",
           "Nevalainen2021 Eq. (21); §4.1"},
          s.coefficient, power_coefficient_names());
  v.field({"side", "", "on which side the share acts: right as printed, or left",
           "Nevalainen2021 Eq. (19)"},
          s.side, update_side_names());
  v.field({"acceptance", "", "which matches are used: all, where e falls, or where β falls",
           "choice: Nevalainen2021 §2.2 and §2.5 name both"},
          s.acceptance, {"always", "error_falls", "blur_falls"});
  v.field({"match_overlap_limit", "", "λ of a match below which it is not used",
           "Nevalainen2021 §2.3: λ0 = 0.4"},
          s.match_overlap_limit, Range{0.0, 1.0});
  v.field(
      {"max_blur_rise", "", "largest share of β that one correction may add; 0 is off", "choice"},
      s.max_blur_rise, Range{0.0, 1e6});
  v.field({"use_go_icp", "", "call Go-ICP where the ICP's match does not meet Eq. 27",
           "Nevalainen2021 §2.4"},
          s.use_go_icp);
  v.field(
      {"rounds", "", "how often pairs are sought, chosen and applied", "Nevalainen2021 §2.4: 1"},
      s.rounds, Range{0.0, 1e4});
  v.field({"patience", "", "corrections without a new least β that end the loop; 0: none do",
           "Nevalainen2021 §4 asks for an end condition"},
          s.patience, Range{0.0, 1e9});
  v.group("quality", [&] { describe(v, s.quality); });
  v.group("icp", [&] { describe(v, s.icp); });
  v.group("go_icp", [&] { describe(v, s.go_icp); });
  v.group("blur", [&] { describe(v, s.blur); });
  v.group("metric", [&] { describe(v, s.metric); });
}

std::string_view correction_outcome_name(CorrectionOutcome outcome) {
  switch (outcome) {
    case CorrectionOutcome::kApplied:
      return "applied";
    case CorrectionOutcome::kNotRegistered:
      return "not_registered";
    case CorrectionOutcome::kTooLittleOverlap:
      return "too_little_overlap";
    case CorrectionOutcome::kErrorDidNotFall:
      return "error_did_not_fall";
    case CorrectionOutcome::kBlurDidNotFall:
      return "blur_did_not_fall";
    case CorrectionOutcome::kStoppedByBlurGuard:
      return "stopped_by_blur_guard";
  }
  HONKA_CHECK(false, "every outcome has a name");
}

}  // namespace honka
