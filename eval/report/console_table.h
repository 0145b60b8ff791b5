#pragma once

#include <string>

#include "eval/report/report_model.h"

namespace honka::eval {

/// A table for the terminal: title, protocol, aligned columns. A column with the paper's figures
/// shows "paper | ours" in one cell. Ends with a line break.
[[nodiscard]] std::string console_table(const ReportTable& table);

}  // namespace honka::eval
