#include <fmt/format.h>

#include "eval/cli/verbs.h"
#include "eval/run/score.h"

namespace honka::eval {

int score_verb(const ScoreArguments& arguments) {
  fmt::print("{}", score(arguments.recording, arguments.poses, arguments.stems));
  return 0;
}

}  // namespace honka::eval
