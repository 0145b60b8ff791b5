#include "eval/io/cloud_csv.h"

#include <cmath>
#include <optional>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

/// The column of a coordinate: x_m or x.
std::optional<std::size_t> coordinate_column(const std::filesystem::path& path,
                                             const CellRow& header, const std::string& axis) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text != axis && header[i].text != axis + "_m") continue;
    if (found) {
      throw_at(path, header[i], "coordinate " + axis + " a second time; take one column out");
    }
    found = i;
  }
  return found;
}

std::size_t planar_column(const std::filesystem::path& path, const CellRow& header,
                          const std::string& axis) {
  const auto found = coordinate_column(path, header, axis);
  if (!found) {
    throw_at(path, header.front(),
             "no column '" + axis + "_m'; a cloud needs a header x_m,y_m or x_m,y_m,z_m");
  }
  return *found;
}

double coordinate_in(const std::filesystem::path& path, const Cell& cell, const std::string& name) {
  constexpr double kFarthest_m = 1e8;  // farther than any map projection's coordinate
  const double value = number_in(path, cell, name);
  if (std::abs(value) > kFarthest_m) {
    throw_at(path, cell, "column '" + name + "': " + cell.text + " m is on no map; give metres");
  }
  return value;
}

}  // namespace

std::vector<Eigen::Vector3d> read_cloud_csv(const std::filesystem::path& path) {
  const auto rows = split_rows(read_text_file(path), Separator::kComma);
  if (rows.empty()) {
    throw UserError(path.string() + ": empty; give a header x_m,y_m and a row for each stem");
  }
  const CellRow& header = rows.front();
  const std::size_t x = planar_column(path, header, "x");
  const std::size_t y = planar_column(path, header, "y");
  const auto z = coordinate_column(path, header, "z");
  std::vector<Eigen::Vector3d> points_m;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CellRow& row = rows[i];
    if (row.size() != header.size()) {
      throw_at(path, row.front(),
               std::to_string(row.size()) + " cells where the header has " +
                   std::to_string(header.size()) + "; add or take out commas");
    }
    const bool has_height = z && !row[*z].text.empty();
    points_m.emplace_back(coordinate_in(path, row[x], "x_m"), coordinate_in(path, row[y], "y_m"),
                          has_height ? coordinate_in(path, row[*z], "z_m") : 0.0);
  }
  return points_m;
}

}  // namespace honka::eval
