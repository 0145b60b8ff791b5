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

TimedPose pose_in(const std::filesystem::path& path, const CellRow& row) {
  if (row.size() != kNames.size()) {
    throw_at(path, row.front(),
             std::to_string(row.size()) + " numbers where a TUM row has 8: t x y z qx qy qz qw");
  }
  std::array<double, kNames.size()> v{};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = number_in(path, row[i], kNames[i]);
  const Eigen::Quaterniond rotation(v[7], v[4], v[5], v[6]);
  // Files of four decimals are within 1e-4 of unit length; beyond 1e-2 it is no rotation.
  if (std::abs(rotation.norm() - 1.0) > 1e-2) {
    throw_at(path, row[4],
             "quaternion of length " + exact_text(rotation.norm()) +
                 "; a rotation has length 1, and the order is qx qy qz qw");
  }
  TimedPose pose{v[0], Pose3::Identity()};
  pose.pose.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
  pose.pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

}  // namespace

std::vector<TimedPose> read_tum(const std::filesystem::path& path) {
  std::vector<TimedPose> poses;
  for (const CellRow& row : split_rows(read_text_file(path), Separator::kBlank)) {
    poses.push_back(pose_in(path, row));
    if (poses.size() > 1 && !(poses[poses.size() - 2].time_s < poses.back().time_s)) {
      throw_at(path, row.front(),
               "time " + row.front().text + " does not follow the one before; sort the rows");
    }
  }
  if (poses.empty()) {
    throw UserError(path.string() + ": no poses; give rows of t x y z qx qy qz qw");
  }
  return poses;
}

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
