#include <fmt/format.h>

#include "eval/cli/verbs.h"
#include "eval/report/summary.h"

namespace honka::eval {

int report_verb(const std::filesystem::path& folder) {
  rebuild_report(folder);
  fmt::print("Report: {}\n", (folder / "report.html").string());
  return 0;
}

}  // namespace honka::eval
