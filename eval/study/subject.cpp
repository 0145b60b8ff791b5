#include "eval/study/subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algo/types/user_error.h"
#include "eval/study/subjects/link_subject.h"
#include "eval/study/subjects/localization_subject.h"
#include "eval/study/subjects/sighting_subject.h"

namespace honka::eval {

const std::vector<StudyKind>& study_kinds() {
  static const std::vector<StudyKind> kKinds = {
      sighting_study_kind(),
      localization_study_kind(),
      link_study_kind(),
  };
  return kKinds;
}

const StudyKind& find_study_kind(const ResolvedScenario& resolved) {
  std::vector<std::string> names;
  for (const StudyKind& kind : study_kinds()) {
    if (kind.experiment == resolved.scenario.experiment) return kind;
    names.push_back(kind.experiment);
  }
  const auto origin = resolved.origins.find("experiment");
  throw UserError(
      fmt::format("{}: experiment = \"{}\" cannot be studied; it may be {}",
                  origin == resolved.origins.end() ? resolved.file.string() : origin->second,
                  resolved.scenario.experiment, fmt::join(names, ", ")));
}

}  // namespace honka::eval
