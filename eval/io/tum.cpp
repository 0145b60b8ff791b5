#include "eval/io/tum.h"

#include <array>
#include <cmath>
#include <string>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

constexpr std::array<const char*, 8> kNames = {"t", "x", "y", "z", "qx", "qy", "qz", "qw"};

constexpr std::size_t kPositionColumns = 4;

[[noreturn]] void refuse_width(const std::filesystem::path& path, const CellRow& row,
                               bool positions_suffice) {
  throw_at(path, row.front(),
           std::to_string(row.size()) + " numbers where a TUM row has 8: t x y z qx qy qz qw" +
               (positions_suffice ? ", or all have 4: t x y z" : ""));
}

/// A row of 8 cells, or of 4, whose rotation is then the identity.
TimedPose pose_in(const std::filesystem::path& path, const CellRow& row) {
  std::array<double, kNames.size()> v{};
  for (std::size_t i = 0; i < row.size(); ++i) v[i] = number_in(path, row[i], kNames[i]);
  TimedPose pose{v[0], Pose3::Identity()};
  pose.pose.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
  if (row.size() == kPositionColumns) return pose;
  const Eigen::Quaterniond rotation(v[7], v[4], v[5], v[6]);
  // Files of four decimals are within 1e-4 of unit length; beyond 1e-2 it is no rotation.
  if (std::abs(rotation.norm() - 1.0) > 1e-2) {
    throw_at(path, row[4],
             "quaternion of length " + exact_text(rotation.norm()) +
                 "; a rotation has length 1, and the order is qx qy qz qw");
  }
  pose.pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

TimedPoses read_rows(const std::filesystem::path& path, bool positions_suffice) {
  TimedPoses result;
  std::size_t width = 0;
  for (const CellRow& row : split_rows(read_text_file(path), Separator::kBlank)) {
    if (width == 0) width = row.size();
    const bool known =
        row.size() == kNames.size() || (positions_suffice && row.size() == kPositionColumns);
    if (!known || row.size() != width) refuse_width(path, row, positions_suffice);
    const TimedPose pose = pose_in(path, row);
    if (!result.poses.empty() && !(result.poses.back().time_s < pose.time_s)) {
      throw_at(path, row.front(),
               "time " + row.front().text + " does not follow the one before; sort the rows");
    }
    result.poses.push_back(pose);
  }
  if (result.poses.empty()) {
    throw UserError(path.string() + ": no poses; give rows of t x y z qx qy qz qw");
  }
  result.has_rotations = width == kNames.size();
  return result;
}

}  // namespace

std::vector<TimedPose> read_tum(const std::filesystem::path& path) {
  return read_rows(path, false).poses;
}

TimedPoses read_tum_trajectory(const std::filesystem::path& path) { return read_rows(path, true); }

void write_tum(const std::filesystem::path& path, const std::vector<TimedPose>& poses) {
  std::string text = "# t_s x_m y_m z_m qx qy qz qw\n";
  for (const TimedPose& pose : poses) {
    const Eigen::Vector3d p = pose.pose.translation();
    const Eigen::Quaterniond q(pose.pose.linear());
    text += exact_text(pose.time_s);
    for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
      text.append(" ").append(exact_text(value));
    }
    text += "\n";
  }
  write_file_safely(path, text);
}

}  // namespace honka::eval
