#include "eval/io/frames_csv.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "algo/types/user_error.h"
#include "eval/io/gzip.h"
#include "eval/io/kitti.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

using Path = std::filesystem::path;

/// Position of the one column that has one of two names.
std::size_t column_of(const Path& path, const CellRow& header, const std::string& name,
                      const std::string& other_name) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text != name && header[i].text != other_name) continue;
    if (found) throw_at(path, header[i], "column '" + name + "' a second time; take one out");
    found = i;
  }
  if (found) return *found;
  std::vector<std::string> names;
  for (const Cell& cell : header) names.push_back(cell.text);
  const auto nearest = did_you_mean(name, names);
  throw_at(path, header.front(),
           "no column '" + name + "'" +
               (nearest ? "; did you mean '" + name + "' by '" + *nearest + "'?"
                        : "; frames need a header that names frame, x_m, y_m and z_m"));
}

struct FrameColumns {
  FrameColumns(const Path& path, const CellRow& header)
      : frame(column_of(path, header, "frame", "frame")),
        x(column_of(path, header, "x_m", "x")),
        y(column_of(path, header, "y_m", "y")),
        z(column_of(path, header, "z_m", "z")) {}
  std::size_t frame, x, y, z;
};

std::int64_t frame_number(const Path& path, const Cell& cell) {
  constexpr double kLargest = 1e15;  // whole numbers up to here are exact in a double
  const double value = number_in(path, cell, "frame");
  if (std::abs(value) > kLargest || value != std::floor(value)) {
    throw_at(path, cell, "column 'frame': '" + cell.text + "' is no whole number");
  }
  return static_cast<std::int64_t>(value);
}

/// Empty frames for the numbers that no point has, so that poses by row find their frame.
void fill_gaps(std::vector<SparseFrame>& frames, std::size_t count) {
  std::vector<SparseFrame> all(count);
  for (std::size_t k = 0; k < count; ++k) all[k].number = static_cast<std::int64_t>(k);
  for (SparseFrame& frame : frames) {
    all[static_cast<std::size_t>(frame.number)] = std::move(frame);
  }
  frames = std::move(all);
}

}  // namespace

std::vector<SparseFrame> read_frames_csv(const Path& path) {
  const auto rows = split_rows(read_text_or_gzip(path), Separator::kComma);
  if (rows.empty()) {
    throw UserError(path.string() + ": empty; give a header frame,x_m,y_m,z_m and a row a stem");
  }
  const FrameColumns columns(path, rows.front());
  std::map<std::int64_t, SparseFrame> frames;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CellRow& row = rows[i];
    if (row.size() != rows.front().size()) {
      throw_at(path, row.front(),
               std::to_string(row.size()) + " cells where the header has " +
                   std::to_string(rows.front().size()));
    }
    const std::int64_t number = frame_number(path, row[columns.frame]);
    SparseFrame& frame = frames[number];
    frame.number = number;
    frame.points_m.emplace_back(number_in(path, row[columns.x], "x_m"),
                                number_in(path, row[columns.y], "y_m"),
                                number_in(path, row[columns.z], "z_m"));
  }
  if (frames.empty()) throw UserError(path.string() + ": no stems below the header");
  std::vector<SparseFrame> result;
  for (auto& [number, frame] : frames) result.push_back(std::move(frame));
  return result;
}

FramePoses read_chain_poses(const Path& path, std::vector<SparseFrame>& frames) {
  FramePoses poses = read_pose_rows(path, read_text_or_gzip(path));
  const bool by_number = frames.front().number >= 0 &&
                         static_cast<std::size_t>(frames.back().number) + 1 == poses.size();
  if (by_number) fill_gaps(frames, poses.size());
  if (poses.size() != frames.size()) {
    throw UserError(path.string() + ": " + std::to_string(poses.size()) + " poses for " +
                    std::to_string(frames.size()) +
                    " frames; give one row a frame, or one a number from 0 to the last frame's");
  }
  return poses;
}

}  // namespace honka::eval
