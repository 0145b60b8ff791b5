#pragma once

#include <filesystem>
#include <string>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Text with &, <, >, " and ' made harmless for HTML.
[[nodiscard]] std::string html_escaped(const std::string& text);

/// One offline HTML page; the figures' files, relative to `folder`, are embedded. A figure whose
/// file is missing shows a notice in its place.
[[nodiscard]] std::string render_html(const ReportModel& model,
                                      const std::filesystem::path& folder);

/// Writes folder/report.html safely.
void write_html_report(const std::filesystem::path& folder, const ReportModel& model);

}  // namespace honka::eval
