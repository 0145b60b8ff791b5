#include "tests/support/stem_csv.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace honka::test {
namespace {

using Row = std::vector<std::string>;

Row split(const std::string& line) {
  Row cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// All rows of a CSV, the header first, comments left out.
std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line[0] != '#') rows.push_back(split(line));
  }
  if (rows.empty()) throw std::runtime_error("no header in " + file.string());
  return rows;
}

std::size_t column(const Row& header, const std::string& name) {
  const auto at = std::find(header.begin(), header.end(), name);
  if (at == header.end()) throw std::runtime_error("no column " + name);
  return static_cast<std::size_t>(at - header.begin());
}

}  // namespace

std::vector<Eigen::Vector2d> read_stems(const std::filesystem::path& file) {
  const auto rows = read_rows(file);
  const std::size_t x = column(rows[0], "x_m");
  const std::size_t y = column(rows[0], "y_m");
  std::vector<Eigen::Vector2d> stems;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    stems.emplace_back(std::stod(rows[i].at(x)), std::stod(rows[i].at(y)));
  }
  return stems;
}

std::vector<CasePose> read_case_poses(const std::filesystem::path& file) {
  const auto rows = read_rows(file);
  std::vector<CasePose> poses;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Row& row = rows[i];
    poses.push_back(
        {row.at(column(rows[0], "case")),
         std::stoi(row.at(column(rows[0], "frames"))),
         {{std::stod(row.at(column(rows[0], "x_m"))), std::stod(row.at(column(rows[0], "y_m")))},
          std::stod(row.at(column(rows[0], "yaw_rad")))}});
  }
  return poses;
}

}  // namespace honka::test
