#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "algo/types/stem.h"

namespace honka::eval {

/// A stem list with the text that it was read from, so that a changed list keeps every column,
/// comment and digit of the rows that stay.
class StemCsvFile {
 public:
  /// UserError as of read_stem_csv; a list without stems is one.
  explicit StemCsvFile(const std::filesystem::path& path);

  [[nodiscard]] const StemMap& stems() const { return stems_; }
  /// Line of the file that holds a stem, from 1.
  [[nodiscard]] std::size_t line_of(std::size_t stem) const { return rows_.at(stem).line; }
  /// What its column "id" says; empty where there is none.
  [[nodiscard]] const std::string& id_of(std::size_t stem) const { return rows_.at(stem).id; }

  /// The file's text without the rows of some stems and with a row at its end for each that joins:
  /// x_m and y_m to the millimetre, other cells empty.
  [[nodiscard]] std::string changed(const std::vector<std::size_t>& without,
                                    const std::vector<Eigen::Vector2d>& joining_m) const;

 private:
  struct Row {
    std::size_t line = 0;
    std::string id;
  };

  std::string text_;
  StemMap stems_;
  std::vector<std::string> header_;
  std::vector<Row> rows_;  ///< of each stem
};

}  // namespace honka::eval
