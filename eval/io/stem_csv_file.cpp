#include "eval/io/stem_csv_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "eval/io/csv.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {

StemCsvFile::StemCsvFile(const std::filesystem::path& path)
    : text_(read_text_file(path)), stems_(read_stem_csv(path)) {
  const auto rows = split_rows(text_, Separator::kComma);
  for (const Cell& cell : rows.front()) header_.push_back(cell.text);
  const auto id =
      static_cast<std::size_t>(std::find(header_.begin(), header_.end(), "id") - header_.begin());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    rows_.push_back({rows[i].front().line, id < header_.size() ? rows[i][id].text : ""});
  }
}

std::string StemCsvFile::changed(const std::vector<std::size_t>& without,
                                 const std::vector<Eigen::Vector2d>& joining_m) const {
  std::unordered_set<std::size_t> dropped;
  for (const std::size_t stem : without) dropped.insert(line_of(stem));
  std::string result;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text_.size(); ++line) {
    const std::size_t end = std::min(text_.find('\n', at), text_.size() - 1) + 1;
    if (dropped.count(line) == 0) result.append(text_, at, end - at);
    at = end;
  }
  const std::string line_end = text_.find("\r\n") != std::string::npos ? "\r\n" : "\n";
  if (!joining_m.empty() && result.back() != '\n') result += line_end;
  for (const Eigen::Vector2d& stem_m : joining_m) {
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (i > 0) result += ',';
      if (header_[i] == "x_m") result += fmt::format("{:.3f}", stem_m.x());
      if (header_[i] == "y_m") result += fmt::format("{:.3f}", stem_m.y());
    }
    result += line_end;
  }
  return result;
}

}  // namespace honka::eval
