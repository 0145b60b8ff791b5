#include "eval/report/console_table.h"

#include <algorithm>

namespace honka::eval {
namespace {

/// Letters of a UTF-8 text: all bytes but those that continue one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded_left(const std::string& text, std::size_t to) {
  return std::string(to - std::min(to, width(text)), ' ') + text;
}

std::string padded_right(const std::string& text, std::size_t to) {
  return text + std::string(to - std::min(to, width(text)), ' ');
}

/// A column as lines of text, header first; all of one width.
std::vector<std::string> column_texts(const ReportTable& table, std::size_t i) {
  std::size_t ours = 0, paper = 0;
  for (const auto& row : table.rows) {
    if (i >= row.size()) continue;
    ours = std::max(ours, width(row[i].text));
    paper = std::max(paper, width(row[i].paper));
  }
  std::vector<std::string> texts = {table.headers[i].name, table.headers[i].unit};
  if (paper > 0) {
    ours = std::max<std::size_t>(ours, 4);
    paper = std::max<std::size_t>(paper, 5);
    texts.push_back(padded_left("paper", paper) + " | " + padded_left("ours", ours));
  } else {
    texts.emplace_back();
  }
  for (const auto& row : table.rows) {
    const ReportCell cell = i < row.size() ? row[i] : ReportCell{};
    const std::string shown = cell.paper.empty() ? "–" : cell.paper;
    texts.push_back(paper == 0 ? cell.text
                               : padded_left(shown, paper) + " | " + padded_left(cell.text, ours));
  }
  std::size_t widest = 0;
  for (const std::string& text : texts) widest = std::max(widest, width(text));
  for (std::string& text : texts) {
    text = i == 0 ? padded_right(text, widest) : padded_left(text, widest);
  }
  return texts;
}

}  // namespace

std::string console_table(const ReportTable& table) {
  constexpr std::size_t kHeaderLines = 3;
  std::vector<std::string> lines(table.rows.size() + kHeaderLines);
  for (std::size_t i = 0; i < table.headers.size(); ++i) {
    const auto texts = column_texts(table, i);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      lines[line] += (i > 0 ? "   " : "") + texts[line];
    }
  }
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, width(line));
  std::string text = table.title + "\n";
  if (!table.protocol.empty()) text += table.protocol + "\n";
  text += "\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].erase(lines[i].find_last_not_of(' ') + 1);
    if (i == kHeaderLines) text += std::string(widest, '-') + "\n";
    if (i >= kHeaderLines || !lines[i].empty()) text += lines[i] + "\n";
  }
  for (const std::string& note : table.notes) text += "  " + note + "\n";
  return text;
}

}  // namespace honka::eval
