#include "eval/report/html_report.h"

#include <algorithm>
#include <cstdint>

#include "eval/io/safe_file.h"
#include "eval/report/html_style.h"

namespace honka::eval {
namespace {

std::string element(const std::string& name, const std::string& text) {
  return "<" + name + ">" + html_escaped(text) + "</" + name + ">\n";
}

std::string list_of(const std::vector<std::string>& items) {
  std::string html = "<ul>\n";
  for (const std::string& item : items) html += element("li", item);
  return html + "</ul>\n";
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const std::uint32_t triple = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[(triple >> (18 - 6 * k)) & 63];
    }
  }
  return text;
}

bool has_paper(const ReportTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return column < row.size() && !row[column].paper.empty();
  });
}

/// A column of sentences or commands, which read from the left and may break.
bool holds_sentences(const ReportTable& table, std::size_t column) {
  constexpr std::size_t kLongest = 40;  // letters of a name or of two numbers
  return column > 0 && std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
           return column < row.size() && row[column].text.size() > kLongest;
         });
}

std::string header_cell(const ReportHeader& header, const std::string& attributes) {
  std::string html = "<th" + attributes + ">" + html_escaped(header.name);
  if (!header.unit.empty()) html += "<span class=\"unit\">" + html_escaped(header.unit) + "</span>";
  return html + "</th>";
}

/// Two lines where any column is paper | ours | difference, else one.
std::string table_head(const ReportTable& table) {
  bool any = false;
  for (std::size_t i = 0; i < table.headers.size(); ++i) any = any || has_paper(table, i);
  std::string upper = "<tr>", lower = "<tr>";
  for (std::size_t i = 0; i < table.headers.size(); ++i) {
    if (has_paper(table, i)) {
      upper += header_cell(table.headers[i], " class=\"group first\" colspan=\"3\"");
      lower += "<th class=\"first\">paper</th><th>ours</th><th>diff.</th>";
    } else {
      const std::string kind = holds_sentences(table, i) ? " class=\"sentence\"" : "";
      upper += header_cell(table.headers[i], kind + (any ? " rowspan=\"2\"" : ""));
    }
  }
  return "<thead>" + upper + "</tr>" + (any ? lower + "</tr>" : "") + "</thead>\n";
}

/// What a column looks like.
struct ColumnLook {
  bool paper = false, sentences = false;
};

std::vector<ColumnLook> column_looks(const ReportTable& table) {
  std::vector<ColumnLook> looks;
  std::size_t columns = table.headers.size();
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  for (std::size_t i = 0; i < columns; ++i) {
    looks.push_back({has_paper(table, i), holds_sentences(table, i)});
  }
  return looks;
}

std::string table_row(const std::vector<ColumnLook>& looks, const std::vector<ReportCell>& row) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string text = html_escaped(row[i].text);
    if (!looks[i].paper) {
      html += (looks[i].sentences ? "<td class=\"sentence\">" : "<td>") + text + "</td>";
      continue;
    }
    const std::string& paper = row[i].paper;
    html += "<td class=\"paper first\">" + (paper.empty() ? "–" : html_escaped(paper)) +
            "</td><td class=\"ours\">" + text + "</td><td class=\"diff\">" +
            html_escaped(row[i].difference) + "</td>";
  }
  return html + "</tr>\n";
}

std::string table_html(const ReportTable& table) {
  std::string html = element("h3", table.title);
  if (!table.protocol.empty()) {
    html += "<p class=\"protocol\">" + html_escaped(table.protocol) + "</p>\n";
  }
  html += "<div class=\"scroll\"><table>" + table_head(table) + "<tbody>\n";
  const std::vector<ColumnLook> looks = column_looks(table);
  for (const auto& row : table.rows) html += table_row(looks, row);
  html += "</tbody></table></div>\n";
  if (!table.notes.empty()) html += "<div class=\"notes\">" + list_of(table.notes) + "</div>\n";
  return html;
}

std::string notice_html(const std::string& text) {
  return "<div class=\"notice\">" + html_escaped(text) + "</div>\n";
}

std::string figure_html(const ReportFigure& figure, const std::filesystem::path& folder) {
  std::string html = "<figure>\n" + element("h3", figure.title);
  const auto path = folder / figure.file;
  if (figure.file.empty()) {
    html += notice_html(figure.notice);
  } else if (!std::filesystem::is_regular_file(path)) {
    html +=
        notice_html(figure.file + " is missing; run gnuplot on its .gp file, then honka report.");
  } else {
    const bool png = path.extension() == ".png";
    html += std::string("<img alt=\"") + html_escaped(figure.title) + "\" src=\"data:image/" +
            (png ? "png" : "svg+xml") + ";base64," + base64(read_text_file(path)) + "\">\n";
  }
  return html + element("figcaption", figure.caption) + "</figure>\n";
}

std::string context_html(const ReportModel& model) {
  std::string html = "<dl>\n";
  const auto add = [&](const std::string& key, const std::string& value) {
    if (!value.empty()) html += element("dt", key) + element("dd", value);
  };
  for (const auto& [key, value] : model.context) add(key, value);
  add("scenario_hash", model.scenario_hash);
  add("results_digest", model.results_digest);
  return html + "</dl>\n";
}

std::string appendix_html(const ReportModel& model) {
  std::string html;
  if (!model.protocol.empty()) html += "<h2>Protocol</h2>\n" + list_of(model.protocol);
  if (!model.reproduce.empty()) {
    html += "<h2>How to reproduce</h2>\n<pre>" + html_escaped(model.reproduce) + "</pre>\n";
  }
  html += "<h2>Context</h2>\n" + context_html(model);
  if (!model.scenario_text.empty()) {
    html += "<h2>Scenario</h2>\n<details><summary>Every key, as resolved</summary>\n<pre>" +
            html_escaped(model.scenario_text) + "</pre></details>\n";
  }
  return html;
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string render_html(const ReportModel& model, const std::filesystem::path& folder) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      html_escaped(model.title) + "</title>\n<style>" + kHtmlStyle + "</style></head>\n<body>\n";
  html += "<header><h1>" + html_escaped(model.title) + "</h1>\n";
  if (!model.question.empty()) {
    html += "<p class=\"question\">" + html_escaped(model.question) + "</p>\n";
  }
  html += "</header>\n";
  if (!model.lead_notes.empty()) {
    html += "<div class=\"lead\">" + list_of(model.lead_notes) + "</div>\n";
  }
  if (!model.tables.empty()) html += "<h2>Tables</h2>\n";
  for (const ReportTable& table : model.tables) html += table_html(table);
  if (!model.figures.empty()) html += "<h2>Figures</h2>\n";
  for (const ReportFigure& figure : model.figures) html += figure_html(figure, folder);
  return html + appendix_html(model) + "</body></html>\n";
}

void write_html_report(const std::filesystem::path& folder, const ReportModel& model) {
  write_file_safely(folder / "report.html", render_html(model, folder));
}

}  // namespace honka::eval
